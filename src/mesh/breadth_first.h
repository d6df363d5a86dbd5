#pragma once

#include <vector>

#include <planish/mesh/patch.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// The used vertices of each part in rings around its smallest vertex: neighbours come near in
/// memory when numbered like this. Linear time.
std::vector<Index> breadth_first_order(const Connectivity& connectivity);

/// The mesh with the vertex order[i] as its vertex i, triangles by their smallest vertex.
/// @pre `order` has all vertices that triangles use, once
TriMesh renumbered(const TriMesh& mesh, const std::vector<Index>& order);

}  // namespace planish
