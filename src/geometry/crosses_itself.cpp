#include "geometry/crosses_itself.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace planish {

namespace {

bool cross_properly(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const double c_side = cross(b - a, c - a), d_side = cross(b - a, d - a);
  const double a_side = cross(d - c, a - c), b_side = cross(d - c, b - c);
  return ((c_side < 0.0 && d_side > 0.0) || (c_side > 0.0 && d_side < 0.0)) &&
         ((a_side < 0.0 && b_side > 0.0) || (a_side > 0.0 && b_side < 0.0));
}

/// Of sides that cross properly.
Vec2 crossing(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const double share = cross(c - a, d - c) / cross(b - a, d - c);
  return a + share * (b - a);
}

LoopOrder one_loop(std::span<const Vec2> polygon) {
  const std::size_t size = polygon.size();
  return LoopOrder(std::span(&size, 1));
}

}  // namespace

bool crosses_itself(std::span<const Vec2> polygon) {
  return crosses_itself(polygon, one_loop(polygon));
}

bool crosses_itself(std::span<const Vec2> points, const LoopOrder& loops) {
  return !crossing_sides(points, loops, 1).empty();
}

std::vector<Vec2> self_crossings(std::span<const Vec2> polygon, std::size_t most) {
  return self_crossings(polygon, one_loop(polygon), most);
}

std::vector<Vec2> self_crossings(std::span<const Vec2> points, const LoopOrder& loops,
                                 std::size_t most) {
  std::vector<Vec2> places;
  for (const auto& [p, q] : crossing_sides(points, loops, most))
    places.push_back(crossing(points[p], points[loops.next(p)], points[q], points[loops.next(q)]));
  return places;
}

std::vector<std::pair<std::size_t, std::size_t>> crossing_sides(std::span<const Vec2> polygon,
                                                                std::size_t most) {
  return crossing_sides(polygon, one_loop(polygon), most);
}

std::vector<std::pair<std::size_t, std::size_t>> crossing_sides(std::span<const Vec2> points,
                                                                const LoopOrder& loops,
                                                                std::size_t most) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  if (most == 0) return pairs;
  const std::size_t n = points.size();
  struct Side {
    Vec2 begin, end;
    double from, to, low, high;  // extent along and across the sweep
    std::size_t number;
  };
  // Swept in a direction that straight sides of a pattern hardly ever are across.
  constexpr Vec2 k_direction{0.7648421872844885, 0.644217687237691};
  std::vector<Side> sides;
  sides.reserve(n);
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 a = points[k], b = points[loops.next(k)];
    const Vec2 p{dot(k_direction, a), cross(k_direction, a)};
    const Vec2 q{dot(k_direction, b), cross(k_direction, b)};
    sides.push_back(
        {a, b, std::min(p.x, q.x), std::max(p.x, q.x), std::min(p.y, q.y), std::max(p.y, q.y), k});
  }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.from < b.from; });
  const auto neighbours = [&loops](std::size_t p, std::size_t q) {
    return loops.next(p) == q || loops.next(q) == p;
  };
  std::vector<const Side*> open;  // that the sweep is passing
  for (const Side& side : sides) {
    open.erase(std::remove_if(open.begin(), open.end(),
                              [&](const Side* other) { return other->to < side.from; }),
               open.end());
    for (const Side* other : open) {
      if (other->high < side.low || other->low > side.high) continue;
      if (!neighbours(side.number, other->number) &&
          cross_properly(side.begin, side.end, other->begin, other->end)) {
        pairs.emplace_back(side.number, other->number);
        if (pairs.size() == most) return pairs;
      }
    }
    open.push_back(&side);
  }
  return pairs;
}

}  // namespace planish
