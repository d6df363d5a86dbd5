#include "unfold/placement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace planish {

namespace {

struct Box {
  Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 high{-low.x, -low.y};

  void add(Vec2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
};

/// Counter-clockwise, without points on its sides (Andrew's monotone chain).
std::vector<Vec2> convex_hull(std::span<const Vec2> points) {
  std::vector<Vec2> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end(),
            [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<Vec2> hull;
  const auto add = [&hull](Vec2 p, std::size_t keep) {
    while (hull.size() >= keep + 2 &&
           cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Vec2 p : sorted)
    add(p, 0);
  const std::size_t lower = hull.size() - 1;
  for (auto p = sorted.rbegin() + 1; p < sorted.rend(); ++p)
    add(*p, lower);
  hull.pop_back();
  return hull;
}

Vec2 turned(Vec2 p, Vec2 axis) {
  return {dot(axis, p), cross(axis, p)};
}

/// The direction of the side of the hull on which the smallest box stands (rotating calipers).
Vec2 smallest_box_axis(const std::vector<Vec2>& hull) {
  const std::size_t n = hull.size();
  Vec2 best{1.0, 0.0};
  double best_area = std::numeric_limits<double>::infinity();
  std::size_t right = 1, top = 1, left = 1;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 side = hull[(i + 1) % n] - hull[i];
    const double length = norm(side);
    if (length == 0.0) continue;
    const Vec2 axis = (1.0 / length) * side;
    // Each of these goes around the hull once as i does.
    const auto advance = [&](std::size_t& k, auto farther) {
      for (std::size_t steps = 0; steps < n && farther(hull[(k + 1) % n] - hull[k % n]); ++steps) {
        ++k;
      }
    };
    right = std::max(right, i + 1);
    advance(right, [&](Vec2 d) { return dot(axis, d) > 0.0; });
    top = std::max(top, right);
    advance(top, [&](Vec2 d) { return cross(axis, d) > 0.0; });
    left = std::max(left, top);
    advance(left, [&](Vec2 d) { return dot(axis, d) < 0.0; });
    const double width = dot(axis, hull[right % n] - hull[left % n]);
    const double height = cross(axis, hull[top % n] - hull[i]);
    if (width * height >= best_area) continue;
    best_area = width * height;
    best = axis;
  }
  return best;
}

}  // namespace

std::vector<Vec2> place_in_smallest_box(std::vector<Vec2> points, std::span<const Vec2> outline) {
  Vec2 axis = smallest_box_axis(convex_hull(outline));
  Box box;
  for (const Vec2 p : outline)
    box.add(turned(p, axis));
  if (box.height() > box.width()) {
    axis = {-axis.y, axis.x};
    box = {};
    for (const Vec2 p : outline)
      box.add(turned(p, axis));
  }
  for (Vec2& p : points)
    p = turned(p, axis) - box.low;
  return points;
}

}  // namespace planish
