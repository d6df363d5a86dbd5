#pragma once

#include <cstddef>
#include <functional>
#include <optional>

#include <planish/flatten/flatten.h>

#include "core/thread_pool.h"

namespace planish {

/// The strain of a design's pattern, and of its pattern of least stretch.
struct StrainOfDesign {
  EdgeStrain now, least;
};

/// How many times the strain of the design its coarse mesh has. Limits are as many times as large
/// there, so that the same share of the strain goes.
struct CoarseStrain {
  double of_edges = 1.0, rms = 1.0;

  StrainLimits scaled(StrainLimits limits) const;
  /// The strain of the design that this of a coarse mesh stands for.
  EdgeStrain scaled_back(EdgeStrain strain) const;
};

/// The job of flattening a design, on a mesh of it with few vertices.
struct CoarseJob {
  Patch patch;
  FlattenOptions options;  ///< how the form changes; without limits
  CoarseStrain strain;
};

/// Flattens a coarse mesh, as flatten().
using CoarseRun = std::function<FlattenReport(const Patch&, const FlattenOptions&, const Context&)>;

/// @return none where constraints name vertices, which a coarser mesh does not have, and where the
///   design cannot be coarsened or its coarse mesh has no pattern
/// @throws Cancelled
std::optional<CoarseJob> coarse_job(const Patch& design, const FlattenOptions& options,
                                    std::size_t vertices, const StrainOfDesign& strain,
                                    const ThreadPool& pool, const Context& context);

/// What a run beside others is run with: one thread, and no progress.
Context alone_with(Context context);

}  // namespace planish
