#include "flatten/steps/evolve_patch.h"

#include <vector>

#include "core/aside.h"
#include "core/job.h"
#include "measure/ruling_defect.h"

namespace planish {

MeasuredPatch measure_patch(const Patch& patch, const Context& context) {
  MeasuredPatch measured;
  measured.inspection = patch.inspection();
  require(measured.inspection, Purpose::measure);
  Aside intersections(context.threads != 1, [&] { return find_self_intersections(patch.mesh()); });
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

namespace {

/// The figures around an evolution of the patch.
template <class Evolve>
EvolveReport report_of_evolving(const Patch& patch, const Method& method, const Stopping& stopping,
                                const Context& context, const Evolve& evolved_now) {
  report_progress(context, {"measuring", 0.0});
  EvolveReport report;
  report.method = method;
  report.stopping = stopping;
  report.before = measure_patch(patch, context);
  report.result = evolved_now();
  const std::vector<Vec3>& after = report.result.positions;
  Aside fairness(context.threads != 1, [&] { return measure_fairness(patch, after); });
  const Patch evolved = patch.with_positions(after);
  stop_if_cancelled(context);
  report.after = measure_patch(evolved, context);
  report.deviation = measure_deviation(patch, after);
  report.border = measure_border_change(patch, after);
  report.fairness = fairness.result();
  return report;
}

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
  return constraints;
}

}  // namespace

EvolveReport evolve_patch(const Patch& patch, const Method& method, const Stopping& stopping,
                          const Constraints& constraints, const Context& context) {
  return report_of_evolving(patch, method, stopping, context,
                            [&] { return evolve(patch, method, stopping, constraints, context); });
}

EvolveReport evolve_remeshed(const Patch& original, const RemeshedPatch& remeshed,
                             const Method& method, const Stopping& stopping,
                             const Context& context) {
  EvolveReport report =
      evolve_patch(remeshed.patch, method, stopping, remeshed.constraints, context);
  if (remeshed.patch.vertex_count() == original.vertex_count()) return report;
  report.remeshed_from = OriginalSize{original.vertex_count(), original.triangles().size()};
  const Patch after = remeshed.patch.with_positions(report.result.positions);
  report.deviation = measure_surface_deviation(original, after.mesh());
  report.fairness = measure_fairness(original, after);
  return report;
}

EvolveReport evolve_half(const Patch& half, const SymmetricWhole& whole, const Method& method,
                         const Stopping& stopping, const Constraints& constraints,
                         const Context& context) {
  return report_of_evolving(half, method, stopping, context, [&] {
    EvolveResult result =
        evolve(whole.patch, method, stopping, of_whole(constraints, whole), context);
    result.positions = half_of(whole, result.positions);
    for (const Index v : constraints.fixed)
      result.positions[v] = half.positions()[v];
    return result;
  });
}

EvolveReport left_as_it_is(const Patch& patch, const std::optional<Method>& method,
                           const Stopping& stopping, StopReason reason, const Context& context) {
  EvolveReport report;
  Aside fairness(context.threads != 1, [&] { return measure_fairness(patch, patch.positions()); });
  report.method = method;
  report.stopping = stopping;
  report.before = report.after = measure_patch(patch, context);
  report.result.positions = patch.positions();
  report.result.stop = reason;
  report.deviation = measure_deviation(patch, patch.positions());
  report.fairness = fairness.result();
  return report;
}

}  // namespace planish
