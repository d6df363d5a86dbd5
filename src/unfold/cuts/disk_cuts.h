#pragma once

#include <vector>

#include <planish/mesh/cut.h>

namespace planish {

/// The mesh cut open along such paths.
CutMesh cut_along(const Patch& patch, std::span<const std::vector<Index>> paths);

/// The vertices of a path of a cut mesh on the mesh that it was made from.
std::vector<Index> on_source(std::span<const Index> path, const CutMesh& cut);

}  // namespace planish
