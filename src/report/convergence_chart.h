#pragma once

#include <string>
#include <vector>

#include <planish/evolve/evolver.h>
#include <planish/measure/flattenability.h>

namespace planish {

/// How e_max, e_avg and energy went, sweep by sweep, each as a share of what it was before, on a
/// logarithmic axis: inline SVG. A figure that was 0 before has no line, and a line ends where the
/// figure reaches 0. Empty where there is no line at all.
std::string convergence_chart(const Flattenability& before,
                              const std::vector<SweepRecord>& history);

}  // namespace planish
