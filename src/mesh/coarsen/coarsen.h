#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>
#include <planish/mesh/tri_mesh.h>

#include "core/thread_pool.h"

namespace planish {

/// A patch over some of the vertices of a finer one.
struct CoarsePatch {
  TriMesh mesh;
  std::vector<Index> source;  ///< vertex of the coarse patch -> vertex of the fine one, increasing
};

/// True for patches of one part with a border, which coarsen() can be sure to take.
bool can_be_coarsened(const Patch& patch);

enum class CoarseBorder {
  thinned,  ///< about as far apart along the border as inside, closer where it bends
  kept,     ///< all vertices and edges; triangles grow from the size of border edges inward
};

/// Takes vertices out of a patch one after another, the most crowded first, by collapses of edges
/// into one of their ends and flips towards Delaunay triangles. Topology, orientation and every
/// loop of the border stay. Triangles that turn by more than 60 degrees against the fine surface
/// are not made, nor are needles, unless those that they replace are worse. The same bits every
/// time. O(n log n).
/// @param patch each part of it has a border
/// @param vertices about this number is left, of very few perhaps none inside; more where none can
/// be
///   taken without harm; if the mesh has no more, it is returned as it is
/// @param keep by vertex: 1 for those that must stay (empty: none)
/// @param pool of the job that it is a part of
/// @throws Cancelled
CoarsePatch coarsen(const Patch& patch, std::size_t vertices, CoarseBorder border,
                    std::span<const unsigned char> keep = {}, const ThreadPool* pool = {});

}  // namespace planish
