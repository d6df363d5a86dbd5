#include "mesh/search/closest_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace planish {

namespace {

Vec3 clamp_to(const Box& box, Vec3 p) {
  return {std::clamp(p.x, box.low.x, box.high.x), std::clamp(p.y, box.low.y, box.high.y),
          std::clamp(p.z, box.low.z, box.high.z)};
}

double squared_length(Vec3 a) {
  return dot(a, a);
}

/// Squared distance of a box from p.
double squared_distance(const Box& box, Vec3 p) {
  return squared_length(clamp_to(box, p) - p);
}

/// The nearest point of the side from corner k to the next.
ClosestPoint closest_on_side(const std::array<Vec3, 3>& corners, std::size_t k, Vec3 p) {
  const std::size_t l = (k + 1) % 3;
  const Vec3 a = corners[k], b = corners[l], side = b - a;
  const double along = dot(p - a, side), whole = squared_length(side);
  ClosestPoint closest;
  if (!(along > 0.0)) {
    closest.point = a;
    closest.barycentric[k] = 1.0;
  } else if (along >= whole) {
    closest.point = b;
    closest.barycentric[l] = 1.0;
  } else {
    const double t = along / whole;
    closest.point = a + t * side;
    closest.barycentric[k] = 1.0 - t;
    closest.barycentric[l] = t;
  }
  return closest;
}

/// The foot of p on the plane of the triangle; on the corner 0 unless it is inside.
ClosestPoint closest_inside(const std::array<Vec3, 3>& corners, Vec3 p) {
  const Vec3 u = corners[1] - corners[0], v = corners[2] - corners[0], d = p - corners[0];
  const Vec3 normal = cross(u, v);
  const double area = squared_length(normal);
  const double at_1 = dot(cross(d, v), normal) / area, at_2 = dot(cross(u, d), normal) / area;
  const double at_0 = 1.0 - at_1 - at_2;
  // False for a triangle without area too.
  if (at_0 > 0.0 && at_1 > 0.0 && at_2 > 0.0)
    return {corners[0] + (at_1 * u + at_2 * v), 0, {at_0, at_1, at_2}};
  return {corners[0], 0, {1.0, 0.0, 0.0}};
}

}  // namespace

/// All candidates are points of the triangle, so the nearest of them is right also where the
/// triangle is a needle and its foot is badly known.
ClosestPoint closest_on_triangle(const std::array<Vec3, 3>& corners, Vec3 p) {
  // Nor can rounding carry the point out of the triangle's box. So no triangle of a box is nearer
  // than the box, in these very numbers, as rounding keeps the order.
  const Box box = box_of(corners);
  ClosestPoint closest;
  closest.squared_distance = std::numeric_limits<double>::infinity();
  const auto offer = [&](ClosestPoint candidate) {
    candidate.point = clamp_to(box, candidate.point);
    candidate.squared_distance = squared_length(candidate.point - p);
    if (candidate.squared_distance < closest.squared_distance) closest = candidate;
  };
  for (std::size_t k = 0; k < 3; ++k)
    offer(closest_on_side(corners, k, p));
  offer(closest_inside(corners, p));
  return closest;
}

ClosestPoint ClosestPointTree::query(Vec3 p) const {
  ClosestPoint best;
  best.squared_distance = std::numeric_limits<double>::infinity();
  best.triangle = std::numeric_limits<Index>::max();
  const auto look_at_leaf = [&](const BoxTree::Node& leaf) {
    for (std::size_t i = leaf.begin; i < leaf.end; ++i) {
      ClosestPoint found = closest_on_triangle(tree_.corners(i), p);
      found.triangle = tree_.triangle(i);
      const bool nearer = found.squared_distance < best.squared_distance;
      const bool as_near = found.squared_distance == best.squared_distance;
      if (nearer || (as_near && found.triangle < best.triangle)) best = found;
    }
  };
  const std::span<const BoxTree::Node> nodes = tree_.nodes();
  // The depth of a tree that halves is below 64.
  std::array<std::size_t, 64> waiting{};
  std::size_t count = 1;
  while (count > 0) {
    const std::size_t number = waiting[--count];
    const BoxTree::Node& node = nodes[number];
    // Equally near ones are looked at, as they may have a smaller number.
    if (squared_distance(node.box, p) > best.squared_distance) continue;
    if (node.is_leaf()) {
      look_at_leaf(node);
      continue;
    }
    std::size_t near = number + 1, far = node.second;
    if (squared_distance(nodes[far].box, p) < squared_distance(nodes[near].box, p))
      std::swap(near, far);
    waiting[count++] = far;
    waiting[count++] = near;
  }
  return best;
}

}  // namespace planish
