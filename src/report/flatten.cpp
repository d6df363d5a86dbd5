#include <atomic>
#include <chrono>
#include <future>
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
  report.deviation = measure_deviation(mesh, after.positions, Connectivity(mesh));
  return report;
}

std::optional<UnfoldReport> unfold_patch(const TriMesh& mesh, Unit unit,
                                         const OnUnfoldStep& on_step) {
  const Connectivity connectivity(mesh);
  bool cancelled = false;
  UnfoldReport report;
  report.unit = unit;
  report.pattern = unfold(mesh, connectivity, {}, [&](int step, double energy) {
    cancelled = on_step && !on_step(step, energy);
    return !cancelled;
  });
  if (cancelled) return std::nullopt;
  report.strain = edge_strain(mesh, connectivity, report.pattern.positions);
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

/// Unfolds both meshes, at the same time where there are threads for it. Progress is told from the
/// calling thread only.
std::optional<std::pair<UnfoldReport, UnfoldReport>> unfold_both(const TriMesh& before,
                                                                 const TriMesh& after, Unit unit,
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
    return unfold_patch(before, unit, [&](int, double) { return !cancelled; });
  };
  auto aside = at_once ? start(unfold_before) : std::nullopt;
  MaybeUnfolded first, second;
  try {
    second = unfold_patch(after, unit, on_step);
  } catch (...) {
    cancelled = true;  // the other one need not go on
    throw;
  }
  if (aside) {
    while (aside->wait_for(std::chrono::milliseconds(50)) != std::future_status::ready)
      tell();
    first = aside->get();
  } else if (second) {
    first = unfold_patch(before, unit, on_step);
  }
  if (!first || !second) return std::nullopt;
  return std::pair{*std::move(first), *std::move(second)};
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
  report.input = std::move(mesh);
  const Stopping stopping = options.stopping.value_or(usual_stopping(options.method));
  EvolveProgress progress(stopping, report.input.positions.size());
  report.evolve = evolve_patch(
      report.input, options.method, stopping,
      [&](const SweepRecord& record) {
        return tell(FlattenStage::evolving, progress.after(record));
      },
      options.threads, options.constraints);
  if (report.evolve.result.stop == StopReason::cancelled) return std::nullopt;
  report.processed = {report.evolve.result.positions, report.input.triangles};

  auto patterns = unfold_both(report.input, report.processed, options.unit,
                              report.evolve.result.threads > 1, on_progress);
  if (!patterns) return std::nullopt;
  report.unfold_before = std::move(patterns->first);
  report.unfold = std::move(patterns->second);
  return report;
}

}  // namespace planish
