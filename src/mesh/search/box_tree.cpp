#include "mesh/search/box_tree.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace planish {

namespace {

constexpr std::size_t k_leaf_size = 4;

double coordinate(Vec3 p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

/// Number of nodes of a tree with this number of triangles.
std::size_t node_count(std::size_t triangles) {
  if (triangles <= k_leaf_size) return 1;
  return 1 + node_count(triangles / 2) + node_count(triangles - triangles / 2);
}

}  // namespace

Box box_of(const BoxTree::Corners& corners) {
  Box box;
  for (const Vec3 p : corners)
    box.add(p);
  return box;
}

BoxTree::BoxTree(TriMesh mesh)
    : positions_(std::move(mesh.positions)),
      triangles_(std::move(mesh.triangles)),
      numbers_(triangles_.size()) {
  std::iota(numbers_.begin(), numbers_.end(), Index{0});
  nodes_.reserve(node_count(numbers_.size()));
  add_node(0, static_cast<Index>(numbers_.size()));
  std::vector<Triangle> in_order;
  in_order.reserve(triangles_.size());
  for (const Index t : numbers_)
    in_order.push_back(triangles_[t]);
  triangles_ = std::move(in_order);
}

Index BoxTree::add_node(Index begin, Index end) {
  Box box, middles;
  const auto middle_of = [this](Index t) {
    const Corners c = corners_of(triangles_[t]);
    return c[0] + c[1] + c[2];
  };
  for (Index place = begin; place < end; ++place) {
    box.add(box_of(corners_of(triangles_[numbers_[place]])));
    middles.add(middle_of(numbers_[place]));
  }
  const auto number = static_cast<Index>(nodes_.size());
  nodes_.push_back({box, begin, end, 0});
  if (end - begin <= k_leaf_size) return number;
  const Vec3 size = middles.high - middles.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const Index half = begin + (end - begin) / 2;
  const auto at = [this](Index place) { return numbers_.begin() + place; };
  std::nth_element(at(begin), at(half), at(end), [&](Index s, Index t) {
    const double a = coordinate(middle_of(s), axis), b = coordinate(middle_of(t), axis);
    return a != b ? a < b : s < t;
  });
  add_node(begin, half);
  nodes_[number].second = add_node(half, end);
  return number;
}

}  // namespace planish
