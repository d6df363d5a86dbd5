#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <planish/core/error.h>
#include <planish/core/range.h>
#include <planish/pattern/notches.h>

#include "core/number_text.h"
#include "pattern/notch_frames.h"
#include "pattern/polygon/polygon_rays.h"

namespace planish {

namespace {

/// A place between a point of a loop and the next one.
struct EdgeSeat {
  std::size_t loop = 0, point = 0;
  double share = 0.0;
};

std::string name_of(std::string_view piece, const Notch& notch) {
  const std::string begin = "piece \"" + std::string(piece) + "\": the notch at ";
  if (!notch.edge) return begin + number_text(notch.fraction) + " of the border";
  const auto [from, to] = *notch.edge;
  const std::string vertex = "vertex " + std::to_string(from);
  return begin + (from == to ? vertex : "the edge from " + vertex + " to " + std::to_string(to));
}

[[noreturn]] void fail(std::string_view piece, const Notch& notch, const std::string& what) {
  SourceLocation place;
  place.first = notch.vertex();
  throw Error(ErrorCode::misplaced_notch, name_of(piece, notch) + what, place);
}

std::optional<std::size_t> point_of(Index vertex, const std::vector<Index>& loop) {
  const auto found = std::find(loop.begin(), loop.end(), vertex);
  if (found == loop.end()) return std::nullopt;
  return static_cast<std::size_t>(found - loop.begin());
}

/// @pre the notch is at a vertex or on an edge
std::optional<EdgeSeat> seat_at(const Notch& notch, std::span<const std::vector<Index>> loops) {
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const auto from = point_of(notch.edge->front(), loops[k]);
    const auto to = point_of(notch.edge->back(), loops[k]);
    if (!from || !to) continue;
    if (from == to) return EdgeSeat{k, *from};
    if ((*from + 1) % loops[k].size() == *to) return EdgeSeat{k, *from, notch.fraction};
    if ((*to + 1) % loops[k].size() == *from) return EdgeSeat{k, *to, 1.0 - notch.fraction};
  }
  return std::nullopt;
}

bool is_share(double value) {
  return value >= 0.0 && value <= 1.0;
}

NotchSeat seat_of(const PieceOutline& outline, const Notch& notch, const NotchFrames& frames) {
  if (!notch.edge) return {0, notch.fraction * frames.walk(0).length()};
  const EdgeSeat seat = *seat_at(notch, outline.vertices);
  const BorderWalk& walk = frames.walk(seat.loop);
  const SeatSide side = notch.vertex()      ? SeatSide::both
                        : seat.share <= 0.5 ? SeatSide::after
                                            : SeatSide::before;
  return {seat.loop, std::lerp(walk.way_to(seat.point), walk.way_to(seat.point + 1), seat.share),
          side};
}

/// How deep a notch is cut: as asked, but where the allowance beside it is narrower than that, and
/// than elsewhere, half of it; where there is none, half as deep as asked, into the piece.
double depth_at(const NotchFrame& frame, const NotchSizes& sizes, const Allowance& allowance) {
  constexpr double k_bare = 1.0;  // millimetres: half of less would not be seen
  if (sizes.depth <= frame.reach + 1e-6 || sizes.depth > allowance.width) return sizes.depth;
  return 0.5 * (frame.reach < k_bare ? sizes.depth : frame.reach);
}

/// @param into_piece it may leave the allowance
void check_depth(const PieceOutline& outline, const Notch& notch, const NotchFrame& frame,
                 double depth, bool into_piece) {
  const std::string deep = " is " + fixed_text(depth, 3) + " mm deep and would reach ";
  if (!into_piece && !(depth <= frame.reach + 1e-6)) {
    fail(outline.piece, notch,
         deep + "through the seam, which is " + fixed_text(frame.reach, 3) + " mm from the cut");
  }
  // On the way it may leave the piece: between the jags of a border.
  const double inside = depth - frame.reach;
  if (into_piece && !is_within(outline.loops, frame.seam + inside * frame.inward))
    fail(outline.piece, notch, deep + "out of the piece");
}

/// The sizes of a notch where it stands.
NotchSizes sizes_at(const PieceOutline& outline, const Notch& notch, const NotchFrame& frame,
                    NotchSizes sizes, const Allowance& allowance, const NotchFrames& frames) {
  if (frame.on_seam) {
    sizes.depth = frame.reach;
    return sizes;
  }
  const double asked = sizes.depth;
  if (frames.has_allowance()) sizes.depth = depth_at(frame, sizes, allowance);
  const bool is_bare = sizes.depth < asked && sizes.depth > frame.reach;
  check_depth(outline, notch, frame, sizes.depth, is_bare || !frames.has_allowance());
  return sizes;
}

/// Where a V begins: on the cut line, half its width to the side.
Vec2 base(const NotchFrame& frame, std::span<const Polygon> cut, double aside, double depth) {
  const Vec2 from = frame.seam + aside * frame.along;
  if (frame.on_seam) return from - frame.reach * frame.inward;
  double reach = first_hit(cut, from, -1.0 * frame.inward, frame.reach - depth);
  if (!(reach <= frame.reach + depth)) reach = frame.reach;
  return from - reach * frame.inward;
}

PlacedNotch placed_notch(NotchKind kind, const NotchFrame& frame, std::span<const Polygon> cut,
                         const NotchSizes& sizes) {
  const double depth = sizes.depth;
  const Vec2 start = frame.seam - frame.reach * frame.inward;
  const Vec2 tip = start + depth * frame.inward;
  const double half = 0.5 * sizes.width;
  PlacedNotch notch = {
      kind, start, frame.inward, depth, kind == NotchKind::slit ? 0.0 : sizes.width, frame.on_seam};
  if (kind == NotchKind::v) {
    notch.strokes = {{base(frame, cut, -half, depth), tip, base(frame, cut, half, depth)}};
  } else {
    notch.strokes = {{start, tip}};
    if (kind == NotchKind::t)
      notch.strokes.push_back({tip - half * frame.along, tip + half * frame.along});
  }
  return notch;
}

void check_sizes(const NotchSizes& sizes) {
  constexpr Range range = {.min = 0.01, .max = 1000.0};
  check_range("notch depth", sizes.depth, range);
  check_range("notch width", sizes.width, range);
  check_range("notch spacing", sizes.spacing, range);
}

/// Where two seams end at one place, as at the tip of a dart, each gives the same notch.
bool is_there_already(const PlacedNotch& notch, std::span<const PlacedNotch> placed) {
  constexpr double k_same = 1e-3;  // millimetres, and of the direction
  return std::any_of(placed.begin(), placed.end(), [&](const PlacedNotch& other) {
    return other.kind == notch.kind && norm(other.at - notch.at) < k_same &&
           norm(other.inward - notch.inward) < k_same;
  });
}

}  // namespace

std::string_view to_string(NotchKind kind) {
  switch (kind) {
    case NotchKind::slit:
      return "slit";
    case NotchKind::v:
      return "v";
    case NotchKind::t:
      return "t";
  }
  return "unknown";
}

void check_notches(std::span<const std::vector<Index>> border, std::span<const Notch> notches,
                   std::string_view piece) {
  for (const Notch& notch : notches) {
    const bool is_on = is_share(notch.fraction) && (!notch.edge || seat_at(notch, border));
    if (is_on) continue;
    const std::string why = !notch.edge      ? "shares are from 0 to 1"
                            : notch.vertex() ? "this vertex is not on it"
                                             : "this edge is not on it";
    fail(piece, notch, " is off the border: " + why);
  }
}

std::vector<PlacedNotch> place_notches(const PieceOutline& outline, std::span<const Polygon> cut,
                                       std::span<const Notch> notches, const NotchSizes& sizes,
                                       const Allowance& allowance) {
  check_sizes(sizes);
  check_notches(outline.vertices, notches, outline.piece);
  if (notches.empty()) return {};
  const NotchFrames frames(outline, cut, allowance, sizes);
  std::vector<PlacedNotch> placed;
  for (const Notch& notch : notches) {
    const NotchSeat seat = seat_of(outline, notch, frames);
    const std::vector<NotchSeat> seats =
        notch.is_double ? frames.pair_around(seat) : std::vector<NotchSeat>{seat};
    for (const NotchSeat& place : seats) {
      const NotchFrame frame = frames.at(place);
      const NotchSizes own = sizes_at(outline, notch, frame, sizes, allowance, frames);
      PlacedNotch found = placed_notch(notch.kind, frame, cut, own);
      if (!is_there_already(found, placed)) placed.push_back(std::move(found));
    }
  }
  return placed;
}

}  // namespace planish
