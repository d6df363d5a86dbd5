#pragma once

#include <span>
#include <vector>

#include <planish/mesh/connectivity.h>

#include "core/thread_pool.h"

namespace planish {

/// Colours for inner vertices such that two of one colour share no inner vertex in their closed
/// one-rings: then neither sees what the other changes, and they may move at the same time with
/// the result of moving one after the other. Greedy, in the given order; colours are counted from
/// 0 and few (about 14 on ordinary meshes). Time is linear for bounded valence and stays near it
/// around vertices of any valence.
/// @param order all inner vertices
/// @return one colour per vertex of the mesh; border and unused vertices get 0
std::vector<Index> distance_two_colors(const Connectivity& connectivity,
                                       std::span<const Index> order, ThreadPool& pool);

}  // namespace planish
