#pragma once

#include <span>
#include <vector>

#include <planish/mesh/cut.h>

namespace planish {

/// Where a closed surface without handles is cut open: along the shortest path from the ring of
/// greatest positive angle defect to the farthest of those with half as much.
/// @param weights as InsidePaths takes them
std::vector<Index> cut_of_closed(const Patch& patch, std::span<const double> weights);

/// The mesh cut open along such paths.
CutMesh cut_along(const Patch& patch, std::span<const std::vector<Index>> paths);

/// The vertices of a path of a cut mesh on the mesh that it was made from.
std::vector<Index> on_source(std::span<const Index> path, const CutMesh& cut);

}  // namespace planish
