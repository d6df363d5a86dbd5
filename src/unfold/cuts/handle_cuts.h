#pragma once

#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// Two paths for each handle, along which a mesh with one border loop or none is to be cut to have
/// none. A greedy system of loops (Erickson and Whittlesey 2005): the shortest paths from one
/// place, the border or the vertex with the smallest number, form a tree; triangles are joined
/// across the edges beyond it, those on the longest loops first; each edge that is left closes a
/// loop.
/// @pre one part; one border loop at most
std::vector<std::vector<Index>> handle_cuts(const Patch& patch);

}  // namespace planish
