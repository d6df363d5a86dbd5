#pragma once

#include <functional>

#include <planish/flatten/flatten.h>

#include "flatten/steps/design.h"
#include "mesh/match/symmetric_whole.h"

namespace planish {

/// The figures around an evolution of a patch.
/// @param measured of the patch
EvolveReport report_of_evolving(const Patch& patch, const MeasuredDesign& measured,
                                const Method& method, const Stopping& stopping,
                                const Context& context,
                                const std::function<EvolveResult()>& evolved);

/// As evolve() of the half of a symmetric whole: what is evolved is the whole.
/// @param constraints of the half
EvolveResult evolve_half(const Patch& half, const SymmetricWhole& whole, const Method& method,
                         const Stopping& stopping, const Constraints& constraints,
                         const Context& context);

/// The figures of a denser surface beside the result; as they were where that has no more vertices.
/// @param worked_on made from the denser one
EvolveReport compared_with_denser(EvolveReport report, const Patch& denser, const Patch& worked_on);

}  // namespace planish
