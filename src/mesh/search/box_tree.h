#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/tri_mesh.h>

#include "geometry/box.h"

namespace planish {

/// A tree of boxes around the triangles of a mesh of any kind, each node halved across the longest
/// extent of its triangles' middles. O(n log n) to build, below 64 deep.
class BoxTree {
 public:
  using Corners = std::array<Vec3, 3>;

  /// A box around some consecutive triangles; a leaf holds a few, another node all of the node that
  /// follows it and of the node `second`.
  struct Node {
    Box box;
    Index begin = 0, end = 0;
    Index second = 0;  // 0 for a leaf

    bool is_leaf() const { return second == 0; }
  };

  /// @param mesh has a triangle at least
  explicit BoxTree(TriMesh mesh);

  std::span<const Node> nodes() const { return nodes_; }  // the root first
  /// The number of a triangle by its place in the order of the tree.
  Index triangle(std::size_t place) const { return numbers_[place]; }
  Corners corners(std::size_t place) const { return corners_of(triangles_[place]); }

 private:
  Index add_node(Index begin, Index end);
  Corners corners_of(const Triangle& t) const {
    return {positions_[t[0]], positions_[t[1]], positions_[t[2]]};
  }

  std::vector<Vec3> positions_;
  std::vector<Triangle> triangles_;  // in the order of the mesh until all nodes are made
  std::vector<Index> numbers_;       // by place
  std::vector<Node> nodes_;
};

Box box_of(const BoxTree::Corners& corners);

}  // namespace planish
