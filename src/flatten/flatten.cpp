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

MeasuredPatch measure_patch(const Patch& patch, unsigned threads) {
  MeasuredPatch measured;
  measured.inspection = patch.inspection();
  require(measured.inspection, Purpose::measure);
  Aside intersections(threads != 1, [&] { return find_self_intersections(patch.mesh()); });
  measured.figures = measure(patch);
  measured.flattenable = is_flattenable(measured.figures, measured.inspection);
  measured.obstruction = find_obstruction(patch);
  measured.bending = measure_bending(patch);
  measured.ruling_defect = ruling_defect(patch);
  measured.self_intersections = intersections.result();
  return measured;
}

EvolveReport evolve_patch(const Patch& patch, const Method& method, const Stopping& stopping,
                          const OnSweep& on_sweep, unsigned threads,
                          const Constraints& constraints) {
  EvolveReport report;
  report.method = method;
  report.stopping = stopping;
  report.before = measure_patch(patch, threads);
  report.result = evolve(patch, method, stopping, on_sweep, threads, constraints);
  const std::vector<Vec3>& after = report.result.positions;
  Aside fairness(threads != 1, [&] { return measure_fairness(patch, after); });
  report.after = measure_patch(patch.with_positions(after), threads);
  report.deviation = measure_deviation(patch, after);
  report.border = measure_border_change(patch, after);
  report.fairness = fairness.result();
  return report;
}

EvolveReport evolve_remeshed(const Patch& original, const RemeshedPatch& remeshed,
                             const Method& method, const Stopping& stopping,
                             const OnSweep& on_sweep, unsigned threads) {
  EvolveReport report =
      evolve_patch(remeshed.patch, method, stopping, on_sweep, threads, remeshed.constraints);
  if (remeshed.patch.vertex_count() == original.vertex_count()) return report;
  report.remeshed_from = OriginalSize{original.vertex_count(), original.triangles().size()};
  const Patch after = remeshed.patch.with_positions(report.result.positions);
  report.deviation = measure_surface_deviation(original, after.mesh());
  report.fairness = measure_fairness(original, after);
  return report;
}

std::optional<UnfoldReport> unfold_patch(const Patch& patch, Unit unit, const OnUnfoldStep& on_step,
                                         const UnfoldOptions& options) {
  bool cancelled = false;
  UnfoldReport report;
  report.unit = unit;
  report.pattern = unfold(patch, options, [&](int step, double energy) {
    cancelled = on_step && !on_step(step, energy);
    return !cancelled;
  });
  if (cancelled) return std::nullopt;
  const auto strain_of = [&](const std::vector<Vec2>& positions) {
    return edge_strain(patch, positions);
  };
  report.strain = strain_of(report.pattern.positions);
  report.border_strain = largest_border_strain(patch, report.pattern.positions);
  if (options.match_seams) report.unmatched_strain = strain_of(report.pattern.unmatched);
  if (!report.pattern.unlimited.empty())
    report.unlimited_strain = strain_of(report.pattern.unlimited);
  report.limits = check_limits(patch, report.pattern.positions, options.limits);
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

/// Unfolds both patches, at the same time where there are threads for it; only the second as asked,
/// as matching the seams of what is far from flattenable takes long and tells little. Progress is
/// told from the calling thread only.
std::optional<std::pair<UnfoldReport, UnfoldReport>> unfold_both(const Patch& before,
                                                                 const Patch& after, Unit unit,
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
EvolveReport left_as_it_is(const Patch& patch, const Method& method, const Stopping& stopping) {
  EvolveReport report;
  report.method = method;
  report.stopping = stopping;
  report.before = report.after = measure_patch(patch);
  report.result.positions = patch.positions();
  report.result.stop = StopReason::strain_met;
  report.deviation = measure_deviation(patch, patch.positions());
  report.fairness = measure_fairness(patch, patch.positions());
  return report;
}

OnSweep on_sweep_of(const Stopping& stopping, const Patch& patch, const OnProgress& on_progress) {
  if (!on_progress) return {};
  const auto progress = std::make_shared<EvolveProgress>(stopping, patch.vertex_count());
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

  std::optional<FlattenReport> run(const Patch& patch, std::string name) {
    if (!tell(FlattenStage::measuring, 0.0)) return std::nullopt;
    require(patch.inspection(), Purpose::unfold);
    report_.name = std::move(name);
    check_constraints(options_.constraints, patch.vertex_count(), method_);
    if (options_.smooth_first > 0.0) return run_smoothed(patch);
    if (options_.remesh) remeshed_ = remesh(patch, options_.constraints, options_.keep);
    if (!work_on(patch)) return std::nullopt;
    if (remeshed_) report_.source = std::move(remeshed_->source);
    return finished(work_patch(patch));
  }

 private:
  std::optional<FlattenReport> run_smoothed(const Patch& raw) {
    if (options_.remesh || !options_.constraints.fixed.empty()) {
      throw Error(ErrorCode::unsupported_constraint,
                  "smooth_first does not go together with remesh, nor with fixed vertices");
    }
    const SmoothedDesign design = smooth_design(raw, options_.smooth_first);
    if (!work_on(design.patch)) return std::nullopt;
    report_.evolve = with_smoothing(std::move(report_.evolve), raw, design.done);
    return finished(design.patch);
  }

  FlattenReport finished(const Patch& worked_on) {
    report_.input = worked_on;
    report_.processed = worked_on.with_positions(report_.evolve.result.positions);
    return std::move(report_);
  }

  /// False when cancelled.
  bool work_on(const Patch& patch) {
    return is_done_as_it_is(work_patch(patch)) ? !is_cancelled() : evolve_to_aim(patch);
  }

  bool tell(FlattenStage stage, double share) {
    cancelled_ = cancelled_ || (on_progress_ && !on_progress_(stage, share));
    return !cancelled_;
  }
  bool is_cancelled() const { return cancelled_; }
  const Patch& work_patch(const Patch& patch) const { return remeshed_ ? remeshed_->patch : patch; }

  UnfoldOptions with_limits() const {
    return {.match_seams = options_.match_seams, .threads = options_.threads, .limits = limits_};
  }

  /// Nothing when cancelled.
  MaybeUnfolded unfolded(const Patch& patch, const UnfoldOptions& how) {
    UnfoldBar bar;
    return unfold_patch(
        patch, options_.unit,
        [&](int, double) { return tell(FlattenStage::unfolding, bar.after_step()); }, how);
  }

  /// What a pattern has of the aim. Strain is measured against the surface that it is made from.
  std::vector<StrainLimitCheck> checks_of_aim(const Patch& patch,
                                              const UnfoldReport& report) const {
    if (limits_.any() || !aim_.any()) return report.limits;
    return check_limits(patch, report.pattern.positions, aim_);
  }

  /// Lays the input flat and sees whether that is all that is to be done. True if that pattern is
  /// the result, or the work was cancelled.
  bool is_done_as_it_is(const Patch& patch) {
    if (!aim_.any()) return false;
    MaybeUnfolded kept = unfolded(patch, with_limits());
    if (!kept) return true;
    const bool is_done = all_kept(checks_of_aim(patch, *kept)),
               is_plain = !limits_.any() && !options_.match_seams;
    if (is_plain) before_ = *kept;
    if (!is_done) return false;
    MaybeUnfolded before = is_plain ? before_ : unfolded(patch, {.threads = options_.threads});
    if (!before) return true;
    report_.evolve = left_as_it_is(patch, method_, stopping_);
    report_.unfold = *std::move(kept);
    report_.unfold_before = *std::move(before);
    return true;
  }

  /// Auto ends by its estimate of the strain. Where the pattern has a little more than that, it is
  /// run again with tighter limits. False when cancelled.
  bool evolve_to_aim(const Patch& patch) {
    constexpr int most_runs = 3;
    Method method = method_;
    for (int run = 1;; ++run) {
      if (!evolve_and_unfold(patch, method)) return false;
      const double share = share_of_limits(checks_of_aim(
          work_patch(patch).with_positions(report_.evolve.result.positions), report_.unfold));
      const bool may_try = report_.evolve.result.stop == StopReason::strain_met && run < most_runs;
      if (!aim_.any() || share >= 1.0 || !may_try) break;
      method = tightened(method, aim_, share);
    }
    report_.evolve.method = method_;
    return go_back(patch);
  }

  /// False when cancelled.
  bool evolve_and_unfold(const Patch& patch, const Method& method) {
    const Patch& work = work_patch(patch);
    const OnSweep on_sweep = on_sweep_of(stopping_, work, on_progress_);
    report_.evolve = remeshed_ ? evolve_remeshed(patch, *remeshed_, method, stopping_, on_sweep,
                                                 options_.threads)
                               : evolve_patch(patch, method, stopping_, on_sweep, options_.threads,
                                              options_.constraints);
    if (report_.evolve.result.stop == StopReason::cancelled) return false;
    const Patch processed = work.with_positions(report_.evolve.result.positions);
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
  bool go_back(const Patch& patch) {
    constexpr int halvings = 6;
    if (!aim_.any() || !limits_.any() || !all_kept(report_.unfold.limits)) return true;
    // Half way between two places on a curved border is beside it.
    if (std::get<Auto>(method_).border.rule != BorderFreedom::Rule::fixed) return true;
    const Patch& work = work_patch(patch);
    const std::vector<Vec3> farthest = report_.evolve.result.positions;
    double fails = 0.0, keeps = 1.0;
    for (int k = 0; k < halvings; ++k) {
      const double share = 0.5 * (fails + keeps);
      const Patch between = work.with_positions(part_way(work.positions(), farthest, share));
      MaybeUnfolded pattern = unfolded(between, with_limits());
      if (!pattern) return false;
      if (!all_kept(pattern->limits)) {
        fails = share;
        continue;
      }
      keeps = share;
      report_.unfold = *std::move(pattern);
      report_.evolve.result.positions = between.positions();
    }
    if (keeps < 1.0) measure_again(patch);
    return true;
  }

  static std::vector<Vec3> part_way(const std::vector<Vec3>& from, const std::vector<Vec3>& to,
                                    double share) {
    std::vector<Vec3> positions = from;
    for (std::size_t v = 0; v < positions.size(); ++v)
      positions[v] = positions[v] + share * (to[v] - positions[v]);
    return positions;
  }

  void measure_again(const Patch& patch) {
    const Patch& work = work_patch(patch);
    const Patch now = work.with_positions(report_.evolve.result.positions);
    report_.evolve.after = measure_patch(now, options_.threads);
    if (report_.evolve.remeshed_from) {
      report_.evolve.deviation = measure_surface_deviation(patch, now.mesh());
      report_.evolve.fairness = measure_fairness(patch, now);
    } else {
      report_.evolve.deviation = measure_deviation(work, now.positions());
      report_.evolve.fairness = measure_fairness(work, now.positions());
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

std::optional<FlattenReport> flatten(const Patch& patch, std::string name,
                                     const FlattenOptions& options, const OnProgress& on_progress) {
  return Flattening(options, on_progress).run(patch, std::move(name));
}

}  // namespace planish
