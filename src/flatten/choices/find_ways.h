#pragma once

#include <vector>

#include <planish/flatten/flatten.h>

#include "flatten/choices/coarse_job.h"

namespace planish {

/// What would keep the limits that a design's pattern misses: those of three materials that do not
/// take the design, the one that takes most, the one that takes least and one between, and 2, 1 and
/// 0.5 % rms, in that order. Each is tried on a
/// coarser mesh of the design, the same for all: estimates. At most k_most_ways.
/// @param patch the design
/// @param options of the run: how limits change the form
/// @param run what tries one of them
/// @return empty where constraints name vertices, which a coarser mesh does not have, and above
///   k_most_vertices_of_ways
/// @throws Cancelled
std::vector<Way> find_ways(const Patch& patch, const FlattenOptions& options,
                           const StrainOfDesign& design, const CoarseRun& run,
                           const Context& context);

/// With the result of the run in the place of its estimate, where it was to keep a limit of one
/// kind: before all others where it was another limit.
std::vector<Way> with_result(std::vector<Way> ways, const FlattenReport& report);

inline constexpr std::size_t k_most_ways = 6;
inline constexpr std::size_t k_most_vertices_of_ways = 500'000;

}  // namespace planish
