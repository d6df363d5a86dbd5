#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// A side of a triangle as an undirected edge.
struct EdgeSide {
  Index low, high;
  Index triangle;
  unsigned char corner;  ///< of the triangle, from which the side begins
  bool forward;          ///< from low to high

  bool same_edge(const EdgeSide& other) const { return low == other.low && high == other.high; }
};

/// The sides of one edge, by triangle.
struct EdgeSides {
  const EdgeSide* begin;
  const EdgeSide* end;
  std::size_t size() const { return static_cast<std::size_t>(end - begin); }
};

/// The sides of all triangles that are not skipped, by edge and then by triangle.
/// @param skipped of each triangle; empty: none
/// @pre all indices are in range
std::vector<EdgeSide> sorted_sides(const TriMesh& mesh,
                                   std::span<const unsigned char> skipped = {});

/// Of sorted sides, which must outlive the result.
std::vector<EdgeSides> group_by_edge(const std::vector<EdgeSide>& sides);

}  // namespace planish
