#include "mesh/closest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace planish {

namespace {

constexpr std::size_t k_leaf_size = 4;

double coordinate(Vec3 p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

Box box_of(const std::array<Vec3, 3>& corners) {
  Box box;
  for (const Vec3 p : corners)
    box.add(p);
  return box;
}

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

}  // namespace

ClosestPointTree::ClosestPointTree(const TriMesh& mesh) : triangles_(mesh.triangles.size()) {
  const auto corners_of = [&](Index t) {
    const Triangle& tri = mesh.triangles[t];
    return Corners{mesh.positions[tri[0]], mesh.positions[tri[1]], mesh.positions[tri[2]]};
  };
  std::iota(triangles_.begin(), triangles_.end(), Index{0});
  corners_.reserve(triangles_.size());
  for (const Index t : triangles_)
    corners_.push_back(corners_of(t));
  nodes_.reserve(2 * (triangles_.size() / k_leaf_size + 1));
  add_node(0, triangles_.size());
  // Only now in the order of the tree: sorting looked corners up by triangle.
  for (std::size_t i = 0; i < triangles_.size(); ++i)
    corners_[i] = corners_of(triangles_[i]);
}

std::size_t ClosestPointTree::add_node(std::size_t begin, std::size_t end) {
  Box box, middles;
  const auto middle_of = [this](Index t) {
    const Corners& c = corners_[t];
    return c[0] + c[1] + c[2];
  };
  for (std::size_t i = begin; i < end; ++i) {
    box.add(box_of(corners_[triangles_[i]]));
    middles.add(middle_of(triangles_[i]));
  }
  const std::size_t number = nodes_.size();
  nodes_.push_back({box, begin, end, 0});
  if (end - begin <= k_leaf_size) return number;
  const Vec3 size = middles.high - middles.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t half = begin + (end - begin) / 2;
  const auto at = [this](std::size_t i) { return triangles_.begin() + static_cast<long>(i); };
  std::nth_element(at(begin), at(half), at(end), [&](Index s, Index t) {
    const double a = coordinate(middle_of(s), axis), b = coordinate(middle_of(t), axis);
    return a != b ? a < b : s < t;
  });
  add_node(begin, half);
  nodes_[number].second = add_node(half, end);
  return number;
}

ClosestPoint ClosestPointTree::query(Vec3 p) const {
  ClosestPoint best;
  best.squared_distance = std::numeric_limits<double>::infinity();
  best.triangle = std::numeric_limits<Index>::max();
  const auto look_at_leaf = [&](const Node& leaf) {
    for (std::size_t i = leaf.begin; i < leaf.end; ++i) {
      ClosestPoint found = closest_on_triangle(corners_[i], p);
      found.triangle = triangles_[i];
      const bool nearer = found.squared_distance < best.squared_distance;
      const bool as_near = found.squared_distance == best.squared_distance;
      if (nearer || (as_near && found.triangle < best.triangle)) best = found;
    }
  };
  // The depth of a tree that halves is below 64.
  std::array<std::size_t, 64> waiting{};
  std::size_t count = 1;
  while (count > 0) {
    const std::size_t number = waiting[--count];
    const Node& node = nodes_[number];
    // Equally near ones are looked at, as they may have a smaller number.
    if (squared_distance(node.box, p) > best.squared_distance) continue;
    if (node.second == 0) {
      look_at_leaf(node);
      continue;
    }
    std::size_t near = number + 1, far = node.second;
    if (squared_distance(nodes_[far].box, p) < squared_distance(nodes_[near].box, p))
      std::swap(near, far);
    waiting[count++] = far;
    waiting[count++] = near;
  }
  return best;
}

}  // namespace planish
