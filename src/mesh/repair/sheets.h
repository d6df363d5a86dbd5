#pragma once

#include <cstddef>
#include <vector>

#include <planish/mesh/tri_mesh.h>

#include "mesh/edge_sides.h"

namespace planish {

/// Triangles that hang together by edges.
struct Sheets {
  std::vector<Index> of_triangle;  ///< number of its sheet; sheets by their first triangles
  std::size_t count = 0;
};

/// @param edges of the mesh's triangles
/// @param most edges of more triangles join nothing; 0: every edge joins
/// @pre all indices are in range
Sheets find_sheets(std::size_t triangles, const std::vector<EdgeSides>& edges,
                   std::size_t most = 0);

/// The same of all triangles of a mesh, joined by every edge.
Sheets find_sheets(const TriMesh& mesh);

/// Triangles that hang together by vertices, in less time. In a manifold they do so by edges.
Sheets find_parts_by_vertices(const TriMesh& mesh);

/// The area of each triangle at the scale of unit_scale().
std::vector<double> unit_areas(const TriMesh& mesh);

/// Sums of the triangles' values over each sheet, in the order of the triangles.
std::vector<double> sums_over(const Sheets& sheets, const std::vector<double>& of_triangle);

}  // namespace planish
