#include "pattern/allowance/darts.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>

#include "core/math.h"
#include "pattern/allowance/bare_ends.h"
#include "pattern/allowance/flap.h"
#include "pattern/polygon/border_walk.h"
#include "pattern/polygon/plane.h"
#include "pattern/polygon/winding_union.h"

namespace planish {

namespace {

struct Leg {
  double length = 0.0;  ///< along the border
  Vec2 chord;           ///< from the tip of the dart
};

bool is_straight(const Leg& leg) {
  constexpr double k_bend = 0.01;  // of the length
  return leg.length - norm(leg.chord) <= k_bend * leg.length;
}

/// @param first from the border to the tip
/// @param second from the tip to the border
bool is_dart(const Leg& first, const Leg& second) {
  constexpr double k_difference = 1.0, k_share = 0.02;
  const double longer = std::max(first.length, second.length);
  return is_straight(first) && is_straight(second) &&
         std::abs(first.length - second.length) <= std::max(k_difference, k_share * longer) &&
         cross(first.chord, second.chord) > 0.0 && dot(first.chord, second.chord) >= 0.0;
}

Leg leg_of(const OutlineEdge& edge, const Polygon& loop, std::size_t tip, std::size_t mouth) {
  return {edge.length, loop[mouth] - loop[tip]};
}

/// The way along a loop from one point on to another one.
double way_between(const BorderWalk& walk, std::size_t from, std::size_t to) {
  const double way = walk.way_to(to) - walk.way_to(from);
  return way < 0.0 ? way + walk.length() : way;
}

Vec2 rotated(Vec2 v, double radians) {
  const double c = math::cos(radians), s = math::sin(radians);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

/// Of several polygons the one with a place on its border, or nothing.
Polygon part_at(Vec2 place, const std::vector<Polygon>& parts) {
  constexpr double k_near = 1e-3;  // millimetres
  for (const Polygon& part : parts) {
    if (!(signed_area(part) > 0.0)) continue;
    for (const Vec2 p : part) {
      if (norm(p - place) < k_near) return part;
    }
  }
  return {};
}

/// What the piece has beside a leg, as far in as half of the dart is wide.
Polygon beside_leg(Vec2 tip, Vec2 along, double half, bool piece_is_left,
                   const std::vector<Polygon>& lines) {
  const Vec2 inner = rotated(along, piece_is_left ? half : -half);
  const double sign = piece_is_left ? 1.0 : -1.0;
  const EndLine bounds[] = {{tip, sign * along}, {tip, -sign * inner}};
  std::vector<Polygon> parts;
  for (const Polygon& line : lines) {
    if (!(signed_area(line) > 0.0)) continue;
    Polygon part = left_of(line, bounds);
    if (signed_area(part) > 0.0) parts.push_back(std::move(part));
  }
  return part_at(tip, winding_union(parts));
}

}  // namespace

std::vector<FoldedDart> darts_of(const PieceOutline& outline) {
  const std::vector<OutlineEdge> edges = edges_between_corners(outline);
  std::vector<FoldedDart> darts;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const OutlineEdge& first = edges[e];
    const auto is_next = [&](const OutlineEdge& edge) {
      return edge.loop == first.loop && edge.points.front() == first.points.back();
    };
    const auto second = std::find_if(edges.begin(), edges.end(), is_next);
    if (second == edges.end()) continue;
    const Polygon& loop = outline.loops[first.loop];
    const FoldedDart dart = {first.loop, first.points.front(), first.points.back(),
                             second->points.back()};
    if (dart.from == dart.to || dart.from == dart.tip) continue;
    if (is_dart(leg_of(first, loop, dart.tip, dart.from), leg_of(*second, loop, dart.tip, dart.to)))
      darts.push_back(dart);
  }
  return darts;
}

std::vector<FoldedDart> darts_toward(const PieceOutline& outline,
                                     const std::vector<LoopStretch>& stretches) {
  std::vector<FoldedDart> darts;
  for (FoldedDart dart : darts_of(outline)) {
    const BorderWalk walk(outline.loops[dart.loop]);
    double nearest = std::numeric_limits<double>::infinity();
    for (const LoopStretch& stretch : stretches) {
      if (stretch.loop != dart.loop) continue;
      const double onwards = way_between(walk, dart.to, stretch.from);
      const double back = way_between(walk, stretch.to, dart.from);
      if (std::min(onwards, back) >= nearest) continue;
      nearest = std::min(onwards, back);
      dart.toward_to = onwards <= back;
    }
    if (std::isfinite(nearest)) darts.push_back(dart);
  }
  return darts;
}

PieceOutline with_straight_darts(PieceOutline outline, const std::vector<FoldedDart>& darts) {
  for (const FoldedDart& dart : darts) {
    straighten(dart.from, dart.tip, outline.loops[dart.loop]);
    straighten(dart.tip, dart.to, outline.loops[dart.loop]);
  }
  return outline;
}

Allowance without_darts(const PieceOutline& outline, Allowance allowance) {
  for (const FoldedDart& dart : allowance.darts) {
    const std::size_t count = outline.loops[dart.loop].size();
    for (std::size_t i = dart.from; i != dart.to; i = (i + 1) % count) {
      allowance.edge_widths[dart.loop][i] = 0.0;
      allowance.folds[dart.loop][i] = 1;
    }
  }
  return allowance;
}

std::vector<Polygon> with_darts(const PieceOutline& outline, const std::vector<FoldedDart>& darts,
                                std::vector<Polygon> lines) {
  const std::vector<Polygon> before = lines;
  for (const FoldedDart& dart : darts) {
    const Polygon& loop = outline.loops[dart.loop];
    const Vec2 tip = loop[dart.tip];
    const Vec2 to_from = direction(tip, loop[dart.from]), to_to = direction(tip, loop[dart.to]);
    const double half = 0.5 * math::atan2(cross(to_from, to_to), dot(to_from, to_to));
    const CreaseLine leg = {tip, dart.toward_to ? to_to : to_from};
    const CreaseLine other = {tip, dart.toward_to ? to_from : to_to};
    const CreaseLine middle = {tip, rotated(to_from, half)};
    const Polygon beside = beside_leg(tip, leg.along, half, dart.toward_to, before);
    if (beside.empty()) continue;
    const Polygon near = mirrored(beside, leg), far = mirrored(near, middle);
    for (const Polygon& part :
         {near, far, strip_over(leg, near), strip_over(middle, near), strip_over(other, far)}) {
      if (!part.empty()) lines.push_back(part);
    }
  }
  return lines.size() == before.size() ? lines : united_flaps(lines);
}

}  // namespace planish
