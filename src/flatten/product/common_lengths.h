#pragma once

#include <optional>
#include <span>
#include <vector>

#include <planish/flatten/product.h>

#include "mesh/match/twins.h"

namespace planish {

/// A patch that is sewn to others or to itself.
struct SewnPatch {
  const TriMesh* mesh;  ///< one that cannot be measured has no seams
  StrainLimits limits = {};
};

/// Whether the edges of a design that keeps its limits stay as they are.
bool keeps_lengths(const FlattenOptions& options);

/// Gives edges along seams whose sides have equal vertices, one by one, a length that is the same
/// in the patterns of all patches: the mean of what they have in patterns of least stretch within
/// the limits. Where a patch keeps the limits in no such pattern, edges that are sewn to it get
/// none, and so keep their own. Twins have the same lengths.
/// @param how patches are laid flat; without limits and seams
/// @param borders of the patches
/// @throws Cancelled
void give_common_lengths(std::span<const Seam> seams, std::span<const SewnPatch> patches,
                         std::span<const std::optional<MeshTwin>> twins, const UnfoldOptions& how,
                         std::vector<SewnBorder>& borders, const Context& context);

}  // namespace planish
