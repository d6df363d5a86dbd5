#include <algorithm>
#include <chrono>
#include <vector>

#include <planish/evolve/evolve.h>
#include <planish/measure/flattenability.h>

#include "core/job.h"
#include "evolve/check_stopping.h"
#include "evolve/evolve_progress.h"
#include "evolve/systems/positions.h"

namespace planish {

namespace {

/// Defects up to this are rounding: no target below it can be asked for.
constexpr double k_rounding_defect = 1e-12;

}  // namespace

void check_stopping(Stopping stopping) {
  describe(stopping, [](std::string_view name, auto value, std::string_view, Range range) {
    check_range(name, static_cast<double>(value), range);
  });
}

std::string_view to_string(StopReason reason) {
  switch (reason) {
    case StopReason::reached_target:
      return "reached_target";
    case StopReason::stalled:
      return "stalled";
    case StopReason::converged:
      return "converged";
    case StopReason::strain_met:
      return "strain_met";
    case StopReason::deviation_limit:
      return "deviation_limit";
    case StopReason::angle_limit:
      return "angle_limit";
    case StopReason::smooth_limit:
      return "smooth_limit";
    case StopReason::sweep_limit:
      return "sweep_limit";
    case StopReason::design_kept:
      return "design_kept";
  }
  return "unknown";
}

std::string_view stop_text(StopReason reason) {
  switch (reason) {
    case StopReason::reached_target:
      return "e_max is at its target, or 0 but for rounding";
    case StopReason::stalled:
      return "no vertex moved any more";
    case StopReason::converged:
      return "the method had converged";
    case StopReason::strain_met:
      return "the strain is within the limit asked for";
    case StopReason::deviation_limit:
      return "going on would have moved vertices further than allowed";
    case StopReason::angle_limit:
      return "going on would have made angles smaller than allowed";
    case StopReason::smooth_limit:
      return "taking out more strain would crumple the surface";
    case StopReason::sweep_limit:
      return "all sweeps asked for were made";
    case StopReason::design_kept:
      return "the design was kept";
  }
  return "unknown";
}

Stopping usual_stopping(const Method& method) {
  Stopping stopping;
  stopping.max_sweeps = std::visit([](const auto& m) { return m.usual_sweeps; }, method);
  return stopping;
}

EvolveResult evolve(const Patch& patch, const Method& method, const Stopping& stopping,
                    const Constraints& constraints, const Context& context) {
  const auto start = std::chrono::steady_clock::now();
  check_stopping(stopping);
  EvolveProgress progress(stopping, patch.vertex_count());
  Context of_step = context;
  if (context.on_progress) {
    of_step.on_progress = [&](const Progress& part) {
      context.on_progress({"evolving", progress.while_opening(part.share)});
    };
  }
  Evolver evolver(patch, method, constraints, of_step);
  EvolveResult result;
  double e_max = summarise_defects(angle_defects(patch), 0).e_max;
  // What is flat to the last digits is not worked on.
  const double target = std::max(stopping.target_e_max, k_rounding_defect);
  const bool closes_holes = std::holds_alternative<Auto>(method);
  const auto met = [&] {
    return e_max <= target && (!closes_holes || holes_close(patch, evolver.positions()));
  };
  result.stop = met() ? StopReason::reached_target : StopReason::sweep_limit;
  for (int sweep = 0; sweep < stopping.max_sweeps && !met(); ++sweep) {
    const SweepRecord& record = result.history.emplace_back(evolver.step());
    e_max = record.e_max;
    if (met()) result.stop = StopReason::reached_target;
    if (!met() && record.status == SweepStatus::stalled) result.stop = StopReason::stalled;
    if (!met() && record.status == SweepStatus::converged) result.stop = record.reason;
    report_progress(context, {"evolving", progress.after(record)});
    if (result.stop != StopReason::sweep_limit) break;
  }
  if (result.stop == StopReason::sweep_limit) evolver.prolong_to_finest();
  result.positions = evolver.positions();
  result.threads = evolver.threads();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  result.seconds = elapsed.count();
  return result;
}

}  // namespace planish
