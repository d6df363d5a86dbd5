#pragma once

#include <utility>

#include <planish/flatten/flatten.h>

namespace planish {

/// Unfolds both patches, at the same time where there are threads for it; only the second as asked,
/// as matching the seams of what is far from flattenable takes long and tells little. Progress is
/// reported from the calling thread only.
/// @throws Error as unfold_patch()
std::pair<UnfoldReport, UnfoldReport> unfold_both(const Patch& before, const Patch& after,
                                                  Unit unit, const UnfoldOptions& how, bool at_once,
                                                  const Context& context);

}  // namespace planish
