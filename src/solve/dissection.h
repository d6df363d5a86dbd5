#pragma once

#include <span>
#include <vector>

#include <planish/core/vec.h>

#include "solve/graph.h"

namespace planish {

/// The vertices in an order of elimination that keeps sparse factors small: what lies in space like
/// a surface is halved by a plane across its longest extent, or where that parts badly across the
/// axis that parts best, or by steps along edges where every plane parts badly, again and again;
/// each half comes before the vertices that part the two (George 1973). O(n log n).
/// @param graph of the matrix: who shares an entry with whom
std::vector<Index> nested_dissection(std::span<const Vec3> positions, const Graph& graph,
                                     std::vector<Index> vertices);
/// The same for all vertices of the graph.
std::vector<Index> nested_dissection(std::span<const Vec3> positions, const Graph& graph);

}  // namespace planish
