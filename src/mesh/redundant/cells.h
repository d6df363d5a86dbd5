#pragma once

#include <array>
#include <span>
#include <vector>

#include <planish/mesh/tri_mesh.h>

#include "mesh/edge_sides.h"

namespace planish {

/// A triangle, or the two on the sides of a diagonal, by its corners.
struct MeshCell {
  static constexpr Index none = static_cast<Index>(-1);

  /// Around it: the smallest first, then the smaller of its neighbours; of a triangle the last is
  /// none.
  std::array<Index, 4> corners;
  bool rising;                     ///< whether this is the way around of its orientation
  std::array<Index, 2> triangles;  ///< the second is none for a triangle

  bool has_same_corners(const MeshCell& other) const { return corners == other.corners; }
};

/// The triangles that name three vertices, those with the same corners beside each other, by
/// orientation and then by number.
/// @param gone triangles that do not count
std::vector<MeshCell> triangle_cells(const TriMesh& mesh, std::span<const unsigned char> gone);

/// The quadrilaterals of two triangles that run alike beside an edge that no other triangle has, in
/// the same order.
std::vector<MeshCell> quad_cells(const TriMesh& mesh, const std::vector<EdgeSides>& edges);

}  // namespace planish
