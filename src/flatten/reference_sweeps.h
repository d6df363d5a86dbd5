#pragma once

#include <vector>

#include <planish/flatten/flatten.h>

namespace planish {

/// How the method of the 2010 paper does on the patch of a report: the history of as many sweeps of
/// ControllableLaplacian as the run had, but 10 at least and 50 at most, without the constraints of
/// the run. None where the run was by that method itself.
/// @throws Cancelled
std::vector<SweepRecord> reference_sweeps(const FlattenReport& report, const Context& context = {});

}  // namespace planish
