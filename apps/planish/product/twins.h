#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include <planish/pattern/pattern_options.h>

#include "mesh/match/twins.h"
#include "product/parts.h"

namespace planish::cli {

/// By patch: the earlier one that it is the mirror image of, or equal to.
using ProductTwins = std::vector<std::optional<MeshTwin>>;

/// @param stopped as find_twins() has it
ProductTwins twins_among(const std::vector<ProductPatch>& patches,
                         const std::function<bool()>& stopped);

/// The options of a twin's own pattern: it is drawn as the other one.
/// @param of the other one's mesh
PatternOptions annotations_of_twin(PatternOptions own, const TriMesh& of, const MeshMatch& match);

/// Patches that are worked on one after another: one and its twins.
using TwinGroup = std::vector<std::size_t>;

/// Divides patches into groups; a twin whose other one is not among them is alone.
/// @param numbers of patches, in any order; groups come in the order of their first ones
std::vector<TwinGroup> groups_of(const std::vector<std::size_t>& numbers,
                                 const ProductTwins& twins);

}  // namespace planish::cli
