#pragma once

#include <array>
#include <span>
#include <vector>

#include <planish/mesh/cut.h>

namespace planish {

/// Every vertex of each path, from end to end.
/// @throws Error as cut_open()
std::vector<std::vector<Index>> full_paths(const Patch& patch, std::span<const CutPath> paths);

/// An edge by its two vertices, the smaller first.
using EdgeEnds = std::array<Index, 2>;

/// The edges of paths, sorted, each once.
std::vector<EdgeEnds> edges_of(std::span<const std::vector<Index>> paths);

/// Refuses paths that would open a hole or nothing.
/// @param full the paths with every vertex
/// @throws Error misplaced_cut
void refuse_idle_cuts(const Patch& patch, std::span<const CutPath> paths,
                      std::span<const std::vector<Index>> full);

/// Opens edges, as cut_open() does, wherever they are.
/// @param paths of inner edges, every vertex
CutMesh open_edges(const Patch& patch, std::vector<std::vector<Index>> paths);

}  // namespace planish
