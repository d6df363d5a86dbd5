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
  if (const auto* vertex = std::get_if<Index>(&notch.place)) {
    return begin + "vertex " + std::to_string(*vertex);
  }
  if (const auto* edge = std::get_if<PlaceOnEdge>(&notch.place)) {
    return begin + "the edge from vertex " + std::to_string(edge->from) + " to " +
           std::to_string(edge->to);
  }
  return begin + number_text(std::get<double>(notch.place)) + " of the border";
}

[[noreturn]] void fail(std::string_view piece, const Notch& notch, const std::string& what) {
  ErrorPlace place;
  if (const auto* vertex = std::get_if<Index>(&notch.place)) place.first = *vertex;
  throw Error(ErrorCode::misplaced_notch, name_of(piece, notch) + what, place);
}

std::optional<std::size_t> point_of(Index vertex, const std::vector<Index>& loop) {
  const auto found = std::find(loop.begin(), loop.end(), vertex);
  if (found == loop.end()) return std::nullopt;
  return static_cast<std::size_t>(found - loop.begin());
}

std::optional<EdgeSeat> seat_at(Index vertex, std::span<const std::vector<Index>> loops) {
  for (std::size_t k = 0; k < loops.size(); ++k) {
    if (const auto point = point_of(vertex, loops[k])) return EdgeSeat{k, *point};
  }
  return std::nullopt;
}

std::optional<EdgeSeat> seat_at(const PlaceOnEdge& place,
                                std::span<const std::vector<Index>> loops) {
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const auto from = point_of(place.from, loops[k]), to = point_of(place.to, loops[k]);
    if (!from || !to) continue;
    if ((*from + 1) % loops[k].size() == *to) return EdgeSeat{k, *from, place.share};
    if ((*to + 1) % loops[k].size() == *from) return EdgeSeat{k, *to, 1.0 - place.share};
  }
  return std::nullopt;
}

bool is_share(double value) {
  return value >= 0.0 && value <= 1.0;
}

NotchSeat seat_of(const PieceOutline& outline, const Notch& notch, const NotchFrames& frames) {
  if (const auto* share = std::get_if<double>(&notch.place))
    return {0, *share * frames.walk(0).length()};
  const auto* edge = std::get_if<PlaceOnEdge>(&notch.place);
  const EdgeSeat seat = edge != nullptr ? *seat_at(*edge, outline.vertices)
                                        : *seat_at(std::get<Index>(notch.place), outline.vertices);
  const BorderWalk& walk = frames.walk(seat.loop);
  const SeatSide side = edge == nullptr     ? SeatSide::both
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
    if (const auto* share = std::get_if<double>(&notch.place)) {
      if (!is_share(*share)) fail(piece, notch, " is off the border: shares are from 0 to 1");
    } else if (const auto* vertex = std::get_if<Index>(&notch.place)) {
      if (!seat_at(*vertex, border)) {
        fail(piece, notch, " is off the border: this vertex is not on it");
      }
    } else {
      const auto& edge = std::get<PlaceOnEdge>(notch.place);
      if (!is_share(edge.share) || !seat_at(edge, border)) {
        fail(piece, notch, " is off the border: this edge is not on it");
      }
    }
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
