#pragma once

#include <vector>

#include <planish/mesh/cut.h>

namespace planish {

/// Short cuts that make a disk of a mesh, by its own vertices: none for a disk. A closed surface is
/// opened along the shortest path from the ring of greatest positive angle defect to the farthest
/// of those with half as much; several borders are joined to the first by shortest paths, the
/// nearest first.
/// @throws Error several_components, handles
std::vector<std::vector<Index>> disk_cuts(const Patch& patch);

/// The mesh cut open along such paths.
CutMesh cut_along(const Patch& patch, std::span<const std::vector<Index>> paths);

/// The vertices of a path of a cut mesh on the mesh that it was made from.
std::vector<Index> on_source(std::span<const Index> path, const CutMesh& cut);

}  // namespace planish
