#pragma once

#include <cstddef>
#include <vector>

#include <planish/mesh/tri_mesh.h>

#include "mesh/disjoint_sets.h"
#include "mesh/edge_sides.h"

namespace planish {

/// The corners of all triangles, 3 t + i for corner i of triangle t, put together in fans: those
/// around a vertex that are to share a copy of it.
using CornerFans = DisjointSets<std::size_t>;

/// Fans of the triangles that share edges. One that is to hold nothing together is left out.
CornerFans corner_fans(const TriMesh& mesh, const std::vector<EdgeSides>& edges);

/// A mesh in which every fan has a vertex of its own.
struct MeshOfFans {
  TriMesh mesh;
  std::vector<Index> source;  ///< of each vertex, the one that it is or copies
  std::size_t divided = 0;    ///< vertices that were given copies
};

/// Gives each fan but the first of each vertex a copy of it. Copies come behind all vertices, by
/// the numbers of what they are copies of.
MeshOfFans with_a_vertex_for_each(const TriMesh& mesh, CornerFans fans);

}  // namespace planish
