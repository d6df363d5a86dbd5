#pragma once

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// How far what is drawn over a mesh may be from it, in mean edges.
inline constexpr double k_most_edges_off = 3.0;

/// The mean length of the sides of all triangles, model units.
/// @pre the mesh has a triangle
double mean_edge_length(const TriMesh& mesh);

}  // namespace planish
