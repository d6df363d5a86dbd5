#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mesh/match/twins.h"

namespace planish {

/// Patches that are worked on one after another: one and its twins.
using TwinGroup = std::vector<std::size_t>;

/// Divides patches into groups; a twin whose other one is not among them is alone.
/// @param numbers of patches, in any order; groups come in the order of their first ones
/// @param twins of all patches
std::vector<TwinGroup> groups_of(std::span<const std::size_t> numbers,
                                 std::span<const std::optional<MeshTwin>> twins);

}  // namespace planish
