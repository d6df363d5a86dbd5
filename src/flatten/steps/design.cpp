#include "flatten/steps/design.h"

#include <utility>

#include <planish/measure/cautions.h>

#include "core/async_task.h"
#include "core/job.h"
#include "flatten/steps/evolve_patch.h"
#include "measure/smoothed.h"
#include "mesh/match/symmetric_whole.h"
#include "unfold/strain/free_edges.h"

namespace planish {

namespace {

bool is_smoothable(const FlattenOptions& options) {
  return !options.remesh && options.constraints.fixed.empty();
}

/// What smoothing first makes of a patch, if it is to be smoothed: within a tolerance alone the
/// noise of a scan goes first.
std::optional<SmoothedDesign> smoothed(const Patch& patch, const Task& task) {
  const FlattenOptions& options = task.options;
  if (options.smooth_first > 0.0) {
    if (is_smoothable(options)) return smooth_design(patch, options.smooth_first);
    throw Error(ErrorCode::unsupported_constraint,
                "smooth_first does not go together with remesh, nor with fixed vertices");
  }
  const double tolerance = task.tolerance().value_or(0.0);
  if (task.limits.any() || options.keep_design || !is_smoothable(options) || !(tolerance > 0.0))
    return std::nullopt;
  const auto noise = find_scan_noise(patch);
  if (!noise) return std::nullopt;
  const BorderFreedom& border = std::get<Auto>(task.method).border;
  const double border_reach = border.rule == BorderFreedom::Rule::within ? border.distance : 0.0;
  return smooth_within(patch, noise->wave, tolerance, border_reach);
}

/// Smoothed or remeshed, not yet measured.
Design worked_on(const Patch& patch, const Task& task) {
  const FlattenOptions& options = task.options;
  Design design{.original = patch,
                .patch = patch,
                .constraints = options.constraints,
                .free_edges = options.free_edges,
                .fold = options.fold};
  if (auto made = smoothed(patch, task)) {
    design.patch = std::move(made->patch);
    design.smoothed = made->done;
    design.cautions = find_cautions(patch, design.patch);
    return design;
  }
  design.cautions = find_cautions(patch);
  if (!options.remesh) return design;
  RemeshedPatch made = remesh(patch, options.constraints, options.keep);
  design.patch = std::move(made.patch);
  design.constraints = std::move(made.constraints);
  design.source = std::move(made.source);
  design.free_edges = renumbered_edges(options.free_edges, design.source);
  if (options.fold) design.fold = renumbered_edges({&*options.fold, 1}, design.source).front();
  return design;
}

}  // namespace

MeasuredDesign measure_design(const Patch& patch, const Context& context) {
  AsyncTask bending(context.threads != 1, [&] { return design_bending(patch); });
  MeasuredDesign measured;
  measured.figures = measure_patch(patch, context);
  measured.bending = bending.result();
  return measured;
}

Design prepare_design(const Patch& patch, const Task& task, const Context& context) {
  require(patch.inspection(), Purpose::unfold);
  check_constraints(task.options.constraints, patch.vertex_count(), task.method);
  Design design = worked_on(patch, task);
  require_unfoldable(design.patch);
  if (!task.keeps_design()) check_size(design.patch, task.method);
  design.measured = measure_design(design.patch, context);
  return design;
}

EvolveReport evolve_design(const Design& design, const Method& method, const Stopping& stopping,
                           const Context& context) {
  const auto whole = design.fold ? symmetric_whole(design.patch, *design.fold) : std::nullopt;
  return report_of_evolving(
      design.patch, design.measured, method, stopping, context, [&]() -> EvolveResult {
        if (whole)
          return evolve_half(design.patch, *whole, method, stopping, design.constraints, context);
        return evolve(design.patch, method, stopping, design.constraints, context);
      });
}

EvolveReport design_as_it_is(const Design& design, const Task& task, StopReason reason) {
  const std::vector<Vec3>& positions = design.patch.positions();
  EvolveReport report;
  if (task.options.may_change()) report.method = task.method;
  report.stopping = task.stopping;
  report.before = report.after = design.measured.figures;
  report.result.positions = positions;
  report.result.stop = reason;
  report.deviation = measure_deviation(design.patch, positions);
  report.fairness = measure_fairness(design.patch, design.measured.bending, positions);
  return report;
}

EvolveReport compared_with_original(EvolveReport report, const Design& design) {
  if (design.smoothed) return with_smoothing(std::move(report), design.original, *design.smoothed);
  return compared_with_denser(std::move(report), design.original, design.patch);
}

EvolveReport measured_again(EvolveReport report, const Design& design, const Context& context) {
  const std::vector<Vec3>& positions = report.result.positions;
  report.after = measure_patch(design.patch.with_positions(positions), context);
  report.deviation = measure_deviation(design.patch, positions);
  report.border = measure_border_change(design.patch, positions);
  report.fairness = measure_fairness(design.patch, design.measured.bending, positions);
  return report;
}

}  // namespace planish
