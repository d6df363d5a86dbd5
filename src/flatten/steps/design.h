#pragma once

#include <array>
#include <optional>
#include <vector>

#include <planish/flatten/flatten.h>

#include "flatten/steps/task.h"

namespace planish {

/// A patch before it is evolved, measured once for all runs.
struct MeasuredDesign {
  MeasuredPatch figures;
  double bending = 0.0;  ///< B0, as design_bending()
};
MeasuredDesign measure_design(const Patch& patch, const Context& context);

/// What flatten() works on.
struct Design {
  Patch original;  ///< as it was given
  Patch patch;     ///< smoothed or remeshed, if that was asked for
  /// Vertex of `patch` -> vertex of `original`, increasing; empty: they are the same.
  std::vector<Index> source = {};
  std::optional<SmoothingSummary> smoothed = {};
  std::vector<Caution> cautions = {};
  // By the vertices of `patch`.
  Constraints constraints = {};
  std::vector<std::array<Index, 2>> free_edges = {};
  std::optional<std::array<Index, 2>> fold = {};
  MeasuredDesign measured = {};  ///< of `patch`
};

/// @throws Error where the patch cannot be worked on as asked: before any long work where its size
///   or its kind is the reason
Design prepare_design(const Patch& patch, const Task& task, const Context& context);

/// Evolves a design, as evolve_patch(). Where it has a fold, its whole is evolved.
EvolveReport evolve_design(const Design& design, const Method& method, const Stopping& stopping,
                           const Context& context);

/// The report of a design that is not evolved.
/// @param reason why nothing moved
EvolveReport design_as_it_is(const Design& design, const Task& task, StopReason reason);

/// The figures of the design that was given beside the result, where another one was worked on.
EvolveReport compared_with_original(EvolveReport report, const Design& design);

/// Figures of the positions that were taken after the report was made.
EvolveReport measured_again(EvolveReport report, const Design& design, const Context& context);

}  // namespace planish
