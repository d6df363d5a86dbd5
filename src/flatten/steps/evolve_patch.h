#pragma once

#include <optional>

#include <planish/flatten/flatten.h>

#include "mesh/match/symmetric_whole.h"

namespace planish {

/// As evolve_patch() of the half of a symmetric whole: what is evolved is the whole.
/// @param constraints of the half
/// @throws Error as evolve_patch()
EvolveReport evolve_half(const Patch& half, const SymmetricWhole& whole, const Method& method,
                         const Stopping& stopping, const Constraints& constraints,
                         const Context& context);

/// The report of a patch that is not evolved.
/// @param method that was asked for; none where nothing was
/// @param reason why nothing moved
EvolveReport left_as_it_is(const Patch& patch, const std::optional<Method>& method,
                           const Stopping& stopping, StopReason reason, const Context& context);

}  // namespace planish
