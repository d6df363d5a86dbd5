#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <system_error>
#include <utility>

#include <planish/report/evolve_progress.h>
#include <planish/report/flatten.h>

namespace planish {

std::string_view to_string(FlattenStage stage) {
  switch (stage) {
    case FlattenStage::measuring:
      return "measuring";
    case FlattenStage::evolving:
      return "evolving";
    case FlattenStage::unfolding:
      return "unfolding";
  }
  return "unknown";
}

MeasuredPatch measure_patch(const TriMesh& mesh) {
  MeasuredPatch patch;
  patch.inspection = inspect(mesh);
  require(patch.inspection, Purpose::measure);
  const Connectivity connectivity(mesh);
  patch.figures = measure(mesh, connectivity);
  patch.flattenable = is_flattenable(patch.figures, patch.inspection);
  patch.obstruction = find_obstruction(mesh, connectivity);
  return patch;
}

EvolveReport evolve_patch(const TriMesh& mesh, const Method& method, const Stopping& stopping,
                          const OnSweep& on_sweep, unsigned threads,
                          const Constraints& constraints) {
  EvolveReport report;
  report.method = method;
  report.stopping = stopping;
  report.before = measure_patch(mesh);
  report.result = evolve(mesh, method, stopping, on_sweep, threads, constraints);
  TriMesh after{report.result.positions, mesh.triangles};
  report.after = measure_patch(after);
  const Connectivity connectivity(mesh);
  report.deviation = measure_deviation(mesh, after.positions, connectivity);
  report.border = measure_border_change(mesh, after.positions, connectivity);
  return report;
}

EvolveReport evolve_remeshed(const TriMesh& original, const RemeshedPatch& patch,
                             const Method& method, const Stopping& stopping,
                             const OnSweep& on_sweep, unsigned threads) {
  EvolveReport report =
      evolve_patch(patch.mesh, method, stopping, on_sweep, threads, patch.constraints);
  if (patch.mesh.positions.size() == original.positions.size()) return report;
  report.remeshed_from = SizeBefore{original.positions.size(), original.triangles.size()};
  report.deviation =
      measure_surface_deviation(original, {report.result.positions, patch.mesh.triangles});
  return report;
}

std::optional<UnfoldReport> unfold_patch(const TriMesh& mesh, Unit unit,
                                         const OnUnfoldStep& on_step,
                                         const UnfoldOptions& options) {
  const Connectivity connectivity(mesh);
  bool cancelled = false;
  UnfoldReport report;
  report.unit = unit;
  report.pattern = unfold(mesh, connectivity, options, [&](int step, double energy) {
    cancelled = on_step && !on_step(step, energy);
    return !cancelled;
  });
  if (cancelled) return std::nullopt;
  const auto strain_of = [&](const std::vector<Vec2>& positions) {
    return edge_strain(mesh, connectivity, positions);
  };
  report.strain = strain_of(report.pattern.positions);
  report.border_strain = largest_border_strain(mesh, connectivity, report.pattern.positions);
  if (options.match_seams) report.unmatched_strain = strain_of(report.pattern.unmatched);
  return report;
}

namespace {

using MaybeUnfolded = std::optional<UnfoldReport>;

/// Starts a task on a thread of its own; nothing where the system has no thread to give.
template <class Task>
std::optional<std::future<MaybeUnfolded>> start(const Task& task) {
  try {
    return std::async(std::launch::async, task);
  } catch (const std::system_error&) {
    return std::nullopt;
  }
}

/// Unfolds both meshes, at the same time where there are threads for it; only the second as asked,
/// as matching the seams of what is far from flattenable takes long and tells little. Progress is
/// told from the calling thread only.
std::optional<std::pair<UnfoldReport, UnfoldReport>> unfold_both(const TriMesh& before,
                                                                 const TriMesh& after, Unit unit,
                                                                 const UnfoldOptions& how,
                                                                 bool at_once,
                                                                 const OnProgress& on_progress) {
  std::atomic<bool> cancelled = false;
  // The number of steps is not known: each takes the bar a tenth of the way that is left.
  double left = 1.0;
  const auto tell = [&] {
    if (on_progress && !on_progress(FlattenStage::unfolding, 1.0 - left)) cancelled = true;
    return !cancelled;
  };
  const auto on_step = [&](int /*step*/, double /*energy*/) {
    left *= 0.9;
    return tell();
  };
  const auto unfold_before = [&] {
    return unfold_patch(before, unit, [&](int, double) { return !cancelled; },
                        {.threads = how.threads});
  };
  auto aside = at_once ? start(unfold_before) : std::nullopt;
  MaybeUnfolded first, second;
  try {
    second = unfold_patch(after, unit, on_step, how);
  } catch (...) {
    cancelled = true;  // the other one need not go on
    throw;
  }
  if (aside) {
    while (aside->wait_for(std::chrono::milliseconds(50)) != std::future_status::ready)
      tell();
    first = aside->get();
  } else if (second) {
    first = unfold_patch(before, unit, on_step, {.threads = how.threads});
  }
  if (!first || !second) return std::nullopt;
  return std::pair{*std::move(first), *std::move(second)};
}

OnSweep on_sweep_of(const Stopping& stopping, const TriMesh& mesh, const OnProgress& on_progress) {
  if (!on_progress) return {};
  const auto progress = std::make_shared<EvolveProgress>(stopping, mesh.positions.size());
  return [progress, on_progress](const SweepRecord& record) {
    return on_progress(FlattenStage::evolving, progress->after(record));
  };
}

}  // namespace

std::optional<FlattenReport> flatten(TriMesh mesh, std::string name, const FlattenOptions& options,
                                     const OnProgress& on_progress) {
  const auto tell = [&](FlattenStage stage, double share) {
    return !on_progress || on_progress(stage, share);
  };
  if (!tell(FlattenStage::measuring, 0.0)) return std::nullopt;
  require(inspect(mesh), Purpose::unfold);

  FlattenReport report;
  report.name = std::move(name);
  const Stopping stopping = options.stopping.value_or(usual_stopping(options.method));
  if (options.remesh) {
    check_constraints(options.constraints, mesh.positions.size(), options.method);
    RemeshedPatch patch = remesh(mesh, options.constraints, options.keep);
    report.evolve =
        evolve_remeshed(mesh, patch, options.method, stopping,
                        on_sweep_of(stopping, patch.mesh, on_progress), options.threads);
    report.input = std::move(patch.mesh);
    report.source = std::move(patch.source);
  } else {
    report.evolve =
        evolve_patch(mesh, options.method, stopping, on_sweep_of(stopping, mesh, on_progress),
                     options.threads, options.constraints);
    report.input = std::move(mesh);
  }
  if (report.evolve.result.stop == StopReason::cancelled) return std::nullopt;
  report.processed = {report.evolve.result.positions, report.input.triangles};

  auto patterns = unfold_both(report.input, report.processed, options.unit,
                              {.match_seams = options.match_seams, .threads = options.threads},
                              report.evolve.result.threads > 1, on_progress);
  if (!patterns) return std::nullopt;
  report.unfold_before = std::move(patterns->first);
  report.unfold = std::move(patterns->second);
  return report;
}

}  // namespace planish
