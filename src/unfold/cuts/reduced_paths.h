#pragma once

#include <span>
#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// The edges of paths that are not on the border, as chains between places on the border, branches
/// and ends. The longest first.
std::vector<std::vector<Index>> inner_chains(const Patch& patch,
                                             std::span<const std::vector<Index>> paths);

/// What is left of paths of edges where no part of them may divide the mesh: of the inner
/// chains that divide it together, the longest are left out. Linear time, but for sorting.
/// @param keep_ends chains may end inside, as those to a tip do; else such are left out too
std::vector<std::vector<Index>> reduced_paths(const Patch& patch,
                                              std::span<const std::vector<Index>> paths,
                                              bool keep_ends);

}  // namespace planish
