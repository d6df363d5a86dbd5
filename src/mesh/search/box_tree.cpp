#include "mesh/search/box_tree.h"

#include <algorithm>
#include <numeric>

namespace planish {

namespace {

constexpr std::size_t k_leaf_size = 4;

double coordinate(Vec3 p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

}  // namespace

Box box_of(const BoxTree::Corners& corners) {
  Box box;
  for (const Vec3 p : corners)
    box.add(p);
  return box;
}

BoxTree::BoxTree(const TriMesh& mesh) : triangles_(mesh.triangles.size()) {
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

std::size_t BoxTree::add_node(std::size_t begin, std::size_t end) {
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

}  // namespace planish
