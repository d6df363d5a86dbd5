#include <algorithm>
#include <atomic>
#include <chrono>
#include <limits>
#include <memory>
#include <span>
#include <utility>

#include <planish/flatten/flatten.h>

#include "core/aside.h"
#include "flatten/evolve_progress.h"
#include "measure/ruling_defect.h"

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

MeasuredPatch measure_patch(const TriMesh& mesh, unsigned threads) {
  MeasuredPatch patch;
  patch.inspection = inspect(mesh);
  require(patch.inspection, Purpose::measure);
  Aside intersections(threads != 1, [&] { return find_self_intersections(mesh); });
  const Connectivity connectivity(mesh);
  patch.figures = measure(mesh, connectivity);
  patch.flattenable = is_flattenable(patch.figures, patch.inspection);
  patch.obstruction = find_obstruction(mesh, connectivity);
  patch.bending = measure_bending(mesh, connectivity);
  patch.ruling_defect = ruling_defect(mesh, connectivity);
  patch.self_intersections = intersections.result();
  return patch;
}

EvolveReport evolve_patch(const TriMesh& mesh, const Method& method, const Stopping& stopping,
                          const OnSweep& on_sweep, unsigned threads,
                          const Constraints& constraints) {
  EvolveReport report;
  report.method = method;
  report.stopping = stopping;
  report.before = measure_patch(mesh, threads);
  report.result = evolve(mesh, method, stopping, on_sweep, threads, constraints);
  TriMesh after{report.result.positions, mesh.triangles};
  const Connectivity connectivity(mesh);
  Aside fairness(threads != 1,
                 [&] { return measure_fairness(mesh, connectivity, after.positions); });
  report.after = measure_patch(after, threads);
  report.deviation = measure_deviation(mesh, after.positions, connectivity);
  report.border = measure_border_change(mesh, after.positions, connectivity);
  report.fairness = fairness.result();
  return report;
}

EvolveReport evolve_remeshed(const TriMesh& original, const RemeshedPatch& patch,
                             const Method& method, const Stopping& stopping,
                             const OnSweep& on_sweep, unsigned threads) {
  EvolveReport report =
      evolve_patch(patch.mesh, method, stopping, on_sweep, threads, patch.constraints);
  if (patch.mesh.positions.size() == original.positions.size()) return report;
  report.remeshed_from = OriginalSize{original.positions.size(), original.triangles.size()};
  const TriMesh after{report.result.positions, patch.mesh.triangles};
  report.deviation = measure_surface_deviation(original, after);
  report.fairness = measure_fairness(original, after);
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
  if (!report.pattern.unlimited.empty())
    report.unlimited_strain = strain_of(report.pattern.unlimited);
  report.limits = check_limits(mesh, connectivity, report.pattern.positions, options.limits);
  return report;
}

namespace {

using MaybeUnfolded = std::optional<UnfoldReport>;

/// How far unfolding is said to be. The number of steps is not known: each takes the bar a tenth of
/// the way that is left.
class UnfoldBar {
 public:
  double share() const { return 1.0 - left_; }
  double after_step() {
    left_ *= 0.9;
    return share();
  }

 private:
  double left_ = 1.0;
};

/// Unfolds both meshes, at the same time where there are threads for it; only the second as asked,
/// as matching the seams of what is far from flattenable takes long and tells little. Progress is
/// told from the calling thread only.
std::optional<std::pair<UnfoldReport, UnfoldReport>> unfold_both(const TriMesh& before,
                                                                 const TriMesh& after, Unit unit,
                                                                 const UnfoldOptions& how,
                                                                 bool at_once,
                                                                 const OnProgress& on_progress) {
  std::atomic<bool> cancelled = false;
  UnfoldBar bar;
  const auto tell = [&](double share) {
    if (on_progress && !on_progress(FlattenStage::unfolding, share)) cancelled = true;
    return !cancelled;
  };
  const auto on_step = [&](int, double) { return tell(bar.after_step()); };
  const auto unfold_before = [&] {
    return unfold_patch(before, unit, [&](int, double) { return !cancelled; },
                        {.threads = how.threads});
  };
  std::future<MaybeUnfolded> aside;
  if (at_once) aside = start_aside(unfold_before);
  MaybeUnfolded first, second;
  try {
    second = unfold_patch(after, unit, on_step, how);
  } catch (...) {
    cancelled = true;  // the other one need not go on
    throw;
  }
  if (aside.valid()) {
    while (aside.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready)
      tell(bar.share());
    first = aside.get();
  } else if (second) {
    first = unfold_patch(before, unit, on_step, {.threads = how.threads});
  }
  if (!first || !second) return std::nullopt;
  return std::pair{*std::move(first), *std::move(second)};
}

/// Those asked for, or else those of the method.
StrainLimits limits_of(const FlattenOptions& options) {
  if (options.limits.any()) return options.limits;
  const auto* method = std::get_if<Auto>(&options.method);
  if (method == nullptr) return {};
  return {.max = method->max_strain, .rms = method->max_rms_strain};
}

/// What a pattern has to keep for the work to be done: the limits, or where none is given and the
/// surface is to stay smooth, a strain that nobody can measure. Nothing where another aim leads.
StrainLimits aim_of(const StrainLimits& limits, const Method& method, const Stopping& stopping) {
  const auto* options = std::get_if<Auto>(&method);
  const bool goes_on = stopping.target_e_max > 0.0;
  if (options == nullptr || goes_on || options->prefer == Prefer::flat) return {};
  if (limits.any() || options->prefer == Prefer::near) return limits;
  return {.rms = k_unmeasurable_strain};
}

/// The method with the limits as its own. Auto ends when its estimate of the strain keeps them.
Method aimed_at(const StrainLimits& limits, Method method) {
  auto* options = std::get_if<Auto>(&method);
  if (options == nullptr) return method;
  if (options->max_strain == 0.0) options->max_strain = std::max(limits.max, limits.p99);
  if (options->max_rms_strain == 0.0) options->max_rms_strain = limits.rms;
  return method;
}

/// By how much strain is to be multiplied to be at its limit; below 1 where a limit is not kept.
double share_of_limits(std::span<const StrainLimitCheck> checks) {
  double share = std::numeric_limits<double>::infinity();
  for (const StrainLimitCheck& check : checks)
    share = std::min(share, check.asked / check.reached);
  return share;
}

/// The method with tighter limits of its own.
Method tightened(Method method, const StrainLimits& aim, double share) {
  constexpr double surely = 0.98;
  auto& options = std::get<Auto>(method);
  if (options.max_strain == 0.0 && options.max_rms_strain == 0.0) options.max_rms_strain = aim.rms;
  options.max_strain *= surely * share;
  options.max_rms_strain *= surely * share;
  return method;
}

/// The report of a patch that needs no evolution.
EvolveReport left_as_it_is(const TriMesh& mesh, const Method& method, const Stopping& stopping) {
  EvolveReport report;
  report.method = method;
  report.stopping = stopping;
  report.before = report.after = measure_patch(mesh);
  report.result.positions = mesh.positions;
  report.result.stop = StopReason::strain_met;
  const Connectivity connectivity(mesh);
  report.deviation = measure_deviation(mesh, mesh.positions, connectivity);
  report.fairness = measure_fairness(mesh, connectivity, mesh.positions);
  return report;
}

OnSweep on_sweep_of(const Stopping& stopping, const TriMesh& mesh, const OnProgress& on_progress) {
  if (!on_progress) return {};
  const auto progress = std::make_shared<EvolveProgress>(stopping, mesh.positions.size());
  return [progress, on_progress](const SweepRecord& record) {
    return on_progress(FlattenStage::evolving, progress->after(record));
  };
}

/// One run of the main job.
class Flattening {
 public:
  Flattening(const FlattenOptions& options, const OnProgress& on_progress)
      : options_(options),
        on_progress_(on_progress),
        limits_(limits_of(options)),
        method_(aimed_at(limits_, options.method)),
        stopping_(options.stopping.value_or(usual_stopping(method_))),
        aim_(aim_of(limits_, method_, stopping_)) {}

  std::optional<FlattenReport> run(TriMesh mesh, std::string name) {
    if (!tell(FlattenStage::measuring, 0.0)) return std::nullopt;
    require(inspect(mesh), Purpose::unfold);
    report_.name = std::move(name);
    check_constraints(options_.constraints, mesh.positions.size(), method_);
    if (options_.smooth_first > 0.0) return run_smoothed(mesh);
    if (options_.remesh) remeshed_ = remesh(mesh, options_.constraints, options_.keep);
    if (!work_on(mesh)) return std::nullopt;
    report_.input = remeshed_ ? std::move(remeshed_->mesh) : std::move(mesh);
    if (remeshed_) report_.source = std::move(remeshed_->source);
    report_.processed = {report_.evolve.result.positions, report_.input.triangles};
    return std::move(report_);
  }

 private:
  std::optional<FlattenReport> run_smoothed(const TriMesh& raw) {
    if (options_.remesh || !options_.constraints.fixed.empty()) {
      throw Error(ErrorCode::unsupported_constraint,
                  "smooth_first does not go together with remesh, nor with fixed vertices");
    }
    SmoothedDesign design = smooth_design(raw, options_.smooth_first);
    if (!work_on(design.mesh)) return std::nullopt;
    report_.evolve = with_smoothing(std::move(report_.evolve), raw, design.done);
    report_.input = std::move(design.mesh);
    report_.processed = {report_.evolve.result.positions, report_.input.triangles};
    return std::move(report_);
  }

  /// False when cancelled.
  bool work_on(const TriMesh& mesh) {
    return is_done_as_it_is(work_mesh(mesh)) ? !is_cancelled() : evolve_to_aim(mesh);
  }

  bool tell(FlattenStage stage, double share) {
    cancelled_ = cancelled_ || (on_progress_ && !on_progress_(stage, share));
    return !cancelled_;
  }
  bool is_cancelled() const { return cancelled_; }
  const TriMesh& work_mesh(const TriMesh& mesh) const { return remeshed_ ? remeshed_->mesh : mesh; }

  UnfoldOptions with_limits() const {
    return {.match_seams = options_.match_seams, .threads = options_.threads, .limits = limits_};
  }

  /// Nothing when cancelled.
  MaybeUnfolded unfolded(const TriMesh& mesh, const UnfoldOptions& how) {
    UnfoldBar bar;
    return unfold_patch(
        mesh, options_.unit,
        [&](int, double) { return tell(FlattenStage::unfolding, bar.after_step()); }, how);
  }

  /// What a pattern has of the aim. Strain is measured against the surface that it is made from.
  std::vector<StrainLimitCheck> checks_of_aim(const TriMesh& mesh,
                                              const UnfoldReport& report) const {
    if (limits_.any() || !aim_.any()) return report.limits;
    return check_limits(mesh, Connectivity(mesh), report.pattern.positions, aim_);
  }

  /// Lays the input flat and sees whether that is all that is to be done. True if that pattern is
  /// the result, or the work was cancelled.
  bool is_done_as_it_is(const TriMesh& mesh) {
    if (!aim_.any()) return false;
    MaybeUnfolded kept = unfolded(mesh, with_limits());
    if (!kept) return true;
    const bool is_done = all_kept(checks_of_aim(mesh, *kept)),
               is_plain = !limits_.any() && !options_.match_seams;
    if (is_plain) before_ = *kept;
    if (!is_done) return false;
    MaybeUnfolded before = is_plain ? before_ : unfolded(mesh, {.threads = options_.threads});
    if (!before) return true;
    report_.evolve = left_as_it_is(mesh, method_, stopping_);
    report_.unfold = *std::move(kept);
    report_.unfold_before = *std::move(before);
    return true;
  }

  /// Auto ends by its estimate of the strain. Where the pattern has a little more than that, it is
  /// run again with tighter limits. False when cancelled.
  bool evolve_to_aim(const TriMesh& mesh) {
    constexpr int most_runs = 3;
    Method method = method_;
    for (int run = 1;; ++run) {
      if (!evolve_and_unfold(mesh, method)) return false;
      const double share = share_of_limits(checks_of_aim(
          {report_.evolve.result.positions, work_mesh(mesh).triangles}, report_.unfold));
      const bool may_try = report_.evolve.result.stop == StopReason::strain_met && run < most_runs;
      if (!aim_.any() || share >= 1.0 || !may_try) break;
      method = tightened(method, aim_, share);
    }
    report_.evolve.method = method_;
    return go_back(mesh);
  }

  /// False when cancelled.
  bool evolve_and_unfold(const TriMesh& mesh, const Method& method) {
    const TriMesh& work = work_mesh(mesh);
    const OnSweep on_sweep = on_sweep_of(stopping_, work, on_progress_);
    report_.evolve =
        remeshed_ ? evolve_remeshed(mesh, *remeshed_, method, stopping_, on_sweep, options_.threads)
                  : evolve_patch(mesh, method, stopping_, on_sweep, options_.threads,
                                 options_.constraints);
    if (report_.evolve.result.stop == StopReason::cancelled) return false;
    const TriMesh processed{report_.evolve.result.positions, work.triangles};
    if (before_) {
      MaybeUnfolded after = unfolded(processed, with_limits());
      if (!after) return false;
      report_.unfold_before = *before_;
      report_.unfold = *std::move(after);
      return true;
    }
    auto patterns = unfold_both(work, processed, options_.unit, with_limits(),
                                report_.evolve.result.threads > 1, on_progress_);
    if (!patterns) return false;
    before_ = report_.unfold_before = std::move(patterns->first);
    report_.unfold = std::move(patterns->second);
    return true;
  }

  /// If the pattern keeps the limits, finds by bisection the smallest share of the move from the
  /// input with which a pattern still keeps them. False when cancelled.
  bool go_back(const TriMesh& mesh) {
    constexpr int halvings = 6;
    if (!aim_.any() || !limits_.any() || !all_kept(report_.unfold.limits)) return true;
    // Half way between two places on a curved border is beside it.
    if (std::get<Auto>(method_).border.rule != BorderFreedom::Rule::fixed) return true;
    const TriMesh& work = work_mesh(mesh);
    const std::vector<Vec3> farthest = report_.evolve.result.positions;
    double fails = 0.0, keeps = 1.0;
    for (int k = 0; k < halvings; ++k) {
      const double share = 0.5 * (fails + keeps);
      const TriMesh between{part_way(work.positions, farthest, share), work.triangles};
      MaybeUnfolded pattern = unfolded(between, with_limits());
      if (!pattern) return false;
      if (!all_kept(pattern->limits)) {
        fails = share;
        continue;
      }
      keeps = share;
      report_.unfold = *std::move(pattern);
      report_.evolve.result.positions = between.positions;
    }
    if (keeps < 1.0) measure_again(mesh);
    return true;
  }

  static std::vector<Vec3> part_way(const std::vector<Vec3>& from, const std::vector<Vec3>& to,
                                    double share) {
    std::vector<Vec3> positions = from;
    for (std::size_t v = 0; v < positions.size(); ++v)
      positions[v] = positions[v] + share * (to[v] - positions[v]);
    return positions;
  }

  void measure_again(const TriMesh& mesh) {
    const TriMesh& work = work_mesh(mesh);
    const TriMesh now{report_.evolve.result.positions, work.triangles};
    report_.evolve.after = measure_patch(now, options_.threads);
    if (report_.evolve.remeshed_from) {
      report_.evolve.deviation = measure_surface_deviation(mesh, now);
      report_.evolve.fairness = measure_fairness(mesh, now);
    } else {
      const Connectivity connectivity(work);
      report_.evolve.deviation = measure_deviation(work, now.positions, connectivity);
      report_.evolve.fairness = measure_fairness(work, connectivity, now.positions);
    }
  }

  const FlattenOptions& options_;
  const OnProgress& on_progress_;
  StrainLimits limits_;
  Method method_;
  Stopping stopping_;
  StrainLimits aim_;
  std::optional<RemeshedPatch> remeshed_;
  FlattenReport report_;
  MaybeUnfolded before_;  // the input without limits, where that is known already
  bool cancelled_ = false;
};

}  // namespace

std::optional<FlattenReport> flatten(TriMesh mesh, std::string name, const FlattenOptions& options,
                                     const OnProgress& on_progress) {
  return Flattening(options, on_progress).run(std::move(mesh), std::move(name));
}

}  // namespace planish
