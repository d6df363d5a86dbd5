#include "flatten/steps/evolve_patch.h"

#include <vector>

#include "core/async_task.h"
#include "core/job.h"
#include "measure/ruling_defect.h"
#include "measure/smoothed.h"

namespace planish {

MeasuredPatch measure_patch(const Patch& patch, const Context& context) {
  MeasuredPatch measured;
  measured.inspection = patch.inspection();
  require(measured.inspection, Purpose::measure);
  AsyncTask intersections(context.threads != 1,
                          [&] { return find_self_intersections(patch.mesh()); });
  measured.size = measure_size(patch);
  measured.figures = measure(patch);
  measured.flattenable = is_flattenable(measured.figures, measured.inspection);
  measured.obstruction = find_obstruction(patch);
  stop_if_cancelled(context);
  measured.bending = measure_bending(patch);
  measured.ruling_defect = ruling_defect(patch);
  stop_if_cancelled(context);
  measured.self_intersections = intersections.result();
  stop_if_cancelled(context);
  return measured;
}

EvolveReport report_of_evolving(const Patch& patch, const MeasuredDesign& measured,
                                const Method& method, const Stopping& stopping,
                                const Context& context,
                                const std::function<EvolveResult()>& evolved) {
  report_progress(context, {"measuring", 0.0});
  EvolveReport report;
  report.method = method;
  report.stopping = stopping;
  report.before = measured.figures;
  report.result = evolved();
  const std::vector<Vec3>& after = report.result.positions;
  AsyncTask fairness(context.threads != 1,
                     [&] { return measure_fairness(patch, measured.bending, after); });
  stop_if_cancelled(context);
  report.after = measure_patch(patch.with_positions(after), context);
  report.deviation = measure_deviation(patch, after);
  report.border = measure_border_change(patch, after);
  report.fairness = fairness.result();
  return report;
}

namespace {

/// Of the half, and the same of its mirror image.
Constraints of_whole(Constraints constraints, const SymmetricWhole& whole) {
  const auto is_paired = [&](Index v) { return whole.image[v] != v; };
  const std::size_t fixed = constraints.fixed.size();
  for (std::size_t k = 0; k < fixed; ++k) {
    const Index v = constraints.fixed[k];
    if (is_paired(v)) constraints.fixed.push_back(whole.image[v]);
  }
  const std::size_t weights = constraints.weights.size();
  for (Index v = 0; v < weights; ++v) {
    if (is_paired(v)) constraints.weights.push_back(constraints.weights[v]);
  }
  constraints.symmetric_in = whole.plane;
  return constraints;
}

}  // namespace

EvolveReport evolve_patch(const Patch& patch, const Method& method, const Stopping& stopping,
                          const Constraints& constraints, const Context& context) {
  report_progress(context, {"measuring", 0.0});
  return report_of_evolving(patch, measure_design(patch, context), method, stopping, context,
                            [&] { return evolve(patch, method, stopping, constraints, context); });
}

EvolveReport compared_with_denser(EvolveReport report, const Patch& denser,
                                  const Patch& worked_on) {
  if (worked_on.vertex_count() == denser.vertex_count()) return report;
  const Patch after = worked_on.with_positions(report.result.positions);
  report.remeshed_from = OriginalSize{denser.vertex_count(), denser.triangles().size()};
  report.deviation = measure_surface_deviation(denser, after.mesh());
  report.fairness = measure_fairness(denser, after);
  return report;
}

EvolveReport evolve_remeshed(const Patch& original, const RemeshedPatch& remeshed,
                             const Method& method, const Stopping& stopping,
                             const Context& context) {
  return compared_with_denser(
      evolve_patch(remeshed.patch, method, stopping, remeshed.constraints, context), original,
      remeshed.patch);
}

EvolveResult evolve_half(const Patch& half, const SymmetricWhole& whole, const Method& method,
                         const Stopping& stopping, const Constraints& constraints,
                         const Context& context) {
  EvolveResult result =
      evolve(whole.patch, method, stopping, of_whole(constraints, whole), context);
  result.positions.resize(whole.half_size);
  for (const Index v : constraints.fixed)
    result.positions[v] = half.positions()[v];
  return result;
}

}  // namespace planish
