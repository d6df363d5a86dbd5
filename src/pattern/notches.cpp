#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>

#include <planish/core/error.h>
#include <planish/core/range.h>
#include <planish/pattern/notches.h>

#include "core/number_text.h"
#include "pattern/polygon/border_walk.h"
#include "pattern/polygon/polygon_rays.h"

namespace planish {

namespace {

/// A place of the seam, by its loop and the way along it.
struct Seat {
  std::size_t loop = 0;
  double way = 0.0;
};

/// A place between a point of a loop and the next one.
struct EdgeSeat {
  std::size_t loop = 0, point = 0;
  double share = 0.0;
};

/// A notch on its cut line.
struct Frame {
  Vec2 seam;           ///< the place on the seam
  Vec2 along;          ///< the direction of the seam, length 1
  Vec2 inward;         ///< at right angles, to the left
  double reach = 0.0;  ///< from the seam out to the cut line
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

Seat seat_of(const PieceOutline& outline, const Notch& notch,
             const std::vector<BorderWalk>& walks) {
  if (const auto* share = std::get_if<double>(&notch.place)) {
    return {0, *share * walks[0].length()};
  }
  const auto* edge = std::get_if<PlaceOnEdge>(&notch.place);
  const EdgeSeat seat = edge != nullptr ? *seat_at(*edge, outline.vertices)
                                        : *seat_at(std::get<Index>(notch.place), outline.vertices);
  const BorderWalk& walk = walks[seat.loop];
  return {seat.loop, std::lerp(walk.way_to(seat.point), walk.way_to(seat.point + 1), seat.share)};
}

/// The seam's direction as it is over the width of a notch, so that jags do not turn notches.
Frame frame_at(const BorderWalk& walk, double way, double width) {
  const double half = std::min(0.5 * width, 0.125 * walk.length());
  Vec2 chord = walk.at(way + half) - walk.at(way - half);
  if (!(norm(chord) > 0.0)) chord = {1.0, 0.0};
  const Vec2 along = 1.0 / norm(chord) * chord;
  return {walk.at(way), along, {-along.y, along.x}};
}

bool has_allowance(const PieceOutline& outline, std::span<const Polygon> cut) {
  return !std::equal(cut.begin(), cut.end(), outline.loops.begin(), outline.loops.end());
}

void check_depth(const PieceOutline& outline, const Notch& notch, const Frame& frame, double depth,
                 bool with_allowance) {
  const std::string deep = " is " + fixed_text(depth, 3) + " mm deep and would reach ";
  if (with_allowance && !(depth <= frame.reach + 1e-6)) {
    fail(outline.piece, notch,
         deep + "through the seam, which is " + fixed_text(frame.reach, 3) + " mm from the cut");
  }
  // On the way it may leave the piece: between the jags of a border.
  if (!with_allowance && !is_within(outline.loops, frame.seam + depth * frame.inward)) {
    fail(outline.piece, notch, deep + "out of the piece");
  }
}

/// Where a V begins: on the cut line, half its width to the side.
Vec2 base(const Frame& frame, std::span<const Polygon> cut, double aside, double depth) {
  const Vec2 from = frame.seam + aside * frame.along;
  double reach = first_hit(cut, from, -1.0 * frame.inward, frame.reach - depth);
  if (!(reach <= frame.reach + depth)) reach = frame.reach;
  return from - reach * frame.inward;
}

PlacedNotch placed_notch(NotchKind kind, const Frame& frame, std::span<const Polygon> cut,
                         const NotchSizes& sizes) {
  const Vec2 start = frame.seam - frame.reach * frame.inward;
  const Vec2 tip = start + sizes.depth * frame.inward;
  const double half = 0.5 * sizes.width;
  PlacedNotch notch = {kind, start, frame.inward, sizes.depth,
                       kind == NotchKind::slit ? 0.0 : sizes.width};
  if (kind == NotchKind::v) {
    notch.strokes = {
        {base(frame, cut, -half, sizes.depth), tip, base(frame, cut, half, sizes.depth)}};
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

std::vector<BorderWalk> walks_along(const PieceOutline& outline) {
  std::vector<BorderWalk> walks;
  walks.reserve(outline.loops.size());
  for (const Polygon& loop : outline.loops)
    walks.emplace_back(loop);
  return walks;
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
                                       std::span<const Notch> notches, const NotchSizes& sizes) {
  check_sizes(sizes);
  check_notches(outline.vertices, notches, outline.piece);
  const std::vector<BorderWalk> walks = walks_along(outline);
  const bool with_allowance = has_allowance(outline, cut);
  std::vector<PlacedNotch> placed;
  for (const Notch& notch : notches) {
    const Seat seat = seat_of(outline, notch, walks);
    const double aside = notch.is_double ? 0.5 * sizes.spacing : 0.0;
    for (const double way : {seat.way - aside, seat.way + aside}) {
      Frame frame = frame_at(walks[seat.loop], way, sizes.width);
      if (with_allowance) {
        // A seam without an allowance of its own lies on the cut line, but for rounding.
        const double hit = first_hit(cut, frame.seam, -1.0 * frame.inward, -1e-3);
        frame.reach = hit == k_no_hit ? 0.0 : hit;
      }
      check_depth(outline, notch, frame, sizes.depth, with_allowance);
      placed.push_back(placed_notch(notch.kind, frame, cut, sizes));
      if (!notch.is_double) break;
    }
  }
  return placed;
}

}  // namespace planish
