#include <algorithm>
#include <cmath>
#include <utility>

#include <planish/flatten/flatten.h>
#include <planish/measure/cautions.h>

#include "core/job.h"
#include "flatten/check_request.h"
#include "flatten/choices/coarse_job.h"
#include "flatten/choices/find_ways.h"
#include "flatten/steps/aim.h"
#include "flatten/steps/evolve_patch.h"
#include "flatten/steps/least_change.h"
#include "flatten/steps/unfold_patch.h"
#include "measure/smoothed.h"
#include "mesh/match/symmetric_whole.h"
#include "unfold/strain/free_edges.h"

namespace planish {

namespace {

/// Of the work that is left, how much a part takes: as measured on patches of 60,000 vertices.
struct WorkShares {
  double design, evolution, pattern;
};

constexpr double k_share_of_plain = 0.03;  // of laying the design flat once more without limits

/// Limits take more than half of the work where they have to be searched for.
WorkShares shares_with(const StrainLimits& limits) {
  return limits.any() ? WorkShares{0.25, 0.2, 0.25} : WorkShares{0.15, 0.87, 0.95};
}

/// Searches of larger patches begin where that of a coarse mesh ended. Where edges have limits they
/// try less: each pattern takes tens of seconds on 60,000 vertices.
constexpr std::size_t k_large = 12'000, k_coarse_vertices = 3'000;
constexpr SearchEffort k_effort_of_large = {
    .runs = 3, .trials = 2, .first_halvings = 2, .last_halvings = 4, .halvings = 4};

/// What the search for the least change came to on a coarse mesh.
struct CoarseSearch {
  std::optional<double> gone;  ///< of the design's strain, by the surface that was found
  bool design_misses = false;  ///< the pattern of the design is far from keeping the limits
};

/// One run of the main job.
class Flattening {
 public:
  Flattening(const FlattenOptions& options, const SearchEffort& effort, const Context& context)
      : options_(options),
        effort_(effort),
        context_(context),
        parts_(context_),
        limits_(limits_of(options)),
        shares_(shares_with(limits_)),
        method_(aimed_at(limits_, how_of(options))),
        stopping_(options.stopping.value_or(usual_stopping(method_))),
        aim_(aim_of(limits_, method_, stopping_)) {}

  FlattenReport run(const Patch& patch, std::string name) {
    report_progress(context_, {"measuring", 0.0});
    require(patch.inspection(), Purpose::unfold);
    report_.name = std::move(name);
    report_.material = options_.material;
    check_constraints(options_.constraints, patch.vertex_count(), method_);
    fold_ = options_.fold;
    free_edges_ = options_.free_edges;
    if (options_.smooth_first > 0.0) {
      require_smoothable();
      return run_smoothed(patch, smooth_design(patch, options_.smooth_first));
    }
    if (const auto noise = noise_to_take_out(patch))
      return run_smoothed(patch, without(*noise, patch));
    report_.cautions = find_cautions(patch);
    if (options_.remesh) {
      remeshed_ = remesh(patch, options_.constraints, options_.keep);
      free_edges_ = renumbered_edges(free_edges_, remeshed_->source);
      if (fold_) fold_ = renumbered_edges({&*fold_, 1}, remeshed_->source).front();
    }
    work_on(patch);
    if (remeshed_) report_.source = std::move(remeshed_->source);
    return finished(work_patch(patch));
  }

 private:
  bool is_smoothable() const { return !options_.remesh && options_.constraints.fixed.empty(); }

  void require_smoothable() const {
    if (is_smoothable()) return;
    throw Error(ErrorCode::unsupported_constraint,
                "smooth_first does not go together with remesh, nor with fixed vertices");
  }

  /// Within a tolerance alone noise goes first.
  std::optional<ScanNoise> noise_to_take_out(const Patch& patch) const {
    if (limits_.any() || options_.keep_design || !is_smoothable() ||
        !(tolerance().value_or(0.0) > 0.0))
      return std::nullopt;
    return find_scan_noise(patch);
  }

  SmoothedDesign without(const ScanNoise& noise, const Patch& patch) const {
    const BorderFreedom& border = std::get<Auto>(method_).border;
    const double border_reach = border.rule == BorderFreedom::Rule::within ? border.distance : 0.0;
    return smooth_within(patch, noise.wave, *tolerance(), border_reach);
  }

  FlattenReport run_smoothed(const Patch& raw, const SmoothedDesign& design) {
    spent_ = design.done.moved.max;
    report_.cautions = find_cautions(raw, design.patch);
    work_on(design.patch);
    report_.evolve = with_smoothing(std::move(report_.evolve), raw, design.done);
    return finished(design.patch);
  }

  FlattenReport finished(const Patch& worked_on) {
    report_.input = worked_on;
    report_.processed = worked_on.with_positions(report_.evolve.result.positions);
    return std::move(report_);
  }

  void work_on(const Patch& patch) {
    // What a later step would refuse by its size is refused before the first.
    require_unfoldable(work_patch(patch));
    if (options_.keep_design || !options_.may_change()) return keep_design(patch);
    check_size(work_patch(patch), method_);
    if (is_done_as_it_is(patch) || stays_near(patch) || changes_least(patch)) return;
    evolve_to_aim(patch);
    if (is_design_as_good()) return take_design(patch, StopReason::strain_met);
    if (is_worse_than_design()) return_to_design(patch);
  }

  const Patch& work_patch(const Patch& patch) const { return remeshed_ ? remeshed_->patch : patch; }

  UnfoldOptions with_limits() const {
    UnfoldOptions how = without_limits();
    how.match_seams = options_.match_seams;
    how.match_if_possible = options_.match_if_possible;
    how.free_edges = free_edges_;
    how.limits = limits_;
    // Where a method was asked for, its surface is led to the limit, not its pattern.
    if (options_.method) how.limits.rms = 0.0;
    return how;
  }

  UnfoldOptions without_limits() const {
    UnfoldOptions how;
    how.least_stretch = true;
    how.fold = fold_;
    return how;
  }

  UnfoldReport unfolded(const Patch& patch, const UnfoldOptions& how, double share) {
    return unfold_patch(patch, options_.unit, how, parts_.next(share));
  }

  UnfoldReport unfolded_within_limits(const Patch& patch, double share) {
    return with_limits_checked(patch, unfolded(patch, with_limits(), share));
  }

  UnfoldReport with_limits_checked(const Patch& patch, UnfoldReport report) const {
    report.limits = check_limits(patch, report.pattern.positions, limits_);
    return report;
  }

  /// What a pattern has of the aim. Strain is measured against the surface that it is made from.
  std::vector<StrainLimitCheck> checks_of_aim(const Patch& patch,
                                              const UnfoldReport& report) const {
    if (limits_.any() || !aim_.any()) return report.limits;
    return check_limits(patch, report.pattern.positions, aim_);
  }

  /// Lays the input flat, as asked and with least stretch: without limits and matching these are
  /// the same.
  void unfold_input(const Patch& patch) {
    UnfoldOptions how = with_limits();
    how.least_stretch = options_.least_stretch || options_.method;
    report_.as_designed =
        with_limits_checked(work_patch(patch), unfolded(work_patch(patch), how, shares_.design));
    const bool is_plain = !limits_.any() && !options_.match_seams;
    if (is_plain)
      before_ = report_.as_designed;
    else if (!before_)
      before_ = unfolded(work_patch(patch), without_limits(), k_share_of_plain);
  }

  void keep_design(const Patch& patch) {
    unfold_input(patch);
    take_design(patch, StopReason::design_kept);
  }

  /// The result is the input with its pattern.
  void take_design(const Patch& patch, StopReason reason) {
    const Patch& work = work_patch(patch);
    report_.unfold_before = *before_;
    report_.unfold = report_.as_designed;
    const auto method = options_.may_change() ? std::optional<Method>(method_) : std::nullopt;
    report_.evolve = left_as_it_is(work, method, stopping_, reason, context_);
    compare_with_original(patch);
  }

  /// Lays the input flat and sees whether that is all that is to be done. True if that pattern is
  /// the result. One that keeps the limits, but overlaps itself, is no pattern to cut: another form
  /// may have a better one.
  bool is_done_as_it_is(const Patch& patch) {
    if (!aim_.any()) return false;
    if (is_searched_on_coarse_mesh(patch)) search_on_coarse_mesh(work_patch(patch));
    if (coarse_search_.design_misses) {
      report_.as_designed = with_limits_checked(work_patch(patch), *before_);
      return false;
    }
    unfold_input(patch);
    design_serves_ = all_kept(checks_of_aim(work_patch(patch), report_.as_designed));
    if (!design_serves_) show_least_stretch(patch);
    if (!design_serves_ || (limits_.any() && report_.as_designed.pattern.overlaps)) return false;
    take_design(patch, StopReason::strain_met);
    return true;
  }

  bool is_searched_on_coarse_mesh(const Patch& patch) const {
    return work_patch(patch).vertex_count() > k_large && limits_.any() && seeks_least_change();
  }

  void search_on_coarse_mesh(const Patch& work) {
    constexpr double far = 0.8;  // of the limits that strain may have
    before_ = unfolded(work, without_limits(), k_share_of_plain);
    const ThreadPool pool(context_);
    const auto coarse = coarse_job(work, options_, k_coarse_vertices,
                                   {before_->strain, before_->strain}, pool, context_);
    if (!coarse) return;
    FlattenOptions job = coarse->options;
    job.limits = coarse->strain.scaled(limits_);
    Context context = context_;
    context.on_progress = {};
    try {
      const FlattenReport found = Flattening(job, {}, context).run(coarse->patch, {});
      coarse_search_.design_misses =
          share_of_limits(
              check_limits(coarse->patch, found.as_designed.pattern.positions, job.limits)) < far;
      if (all_kept(found.unfold.limits))
        coarse_search_.gone = 1.0 - least_strain(found.unfold).rms / found.unfold_before.strain.rms;
    } catch (const Error&) {
      // The search begins as that of a small patch does.
    }
  }

  /// Whether the limits were kept from the beginning, and evolving did not part what overlaps.
  bool is_design_as_good() const {
    return design_serves_ && (report_.unfold.pattern.overlaps || !all_kept(report_.unfold.limits));
  }

  /// A pattern evened out for limits that it misses all the same is no measure of the design.
  void show_least_stretch(const Patch& patch) {
    if (!limits_.any()) return;
    within_limits_ = std::move(report_.as_designed);
    report_.as_designed = *before_;
    report_.as_designed.limits =
        check_limits(work_patch(patch), before_->pattern.positions, limits_);
  }

  /// Whether evolving stretched the pattern of least stretch by more than is worth a word. One that
  /// keeps the limits is not worse, as these are what was asked for.
  bool is_worse_than_design() const {
    constexpr double same = 0.02, not_measurable = 1e-6;
    if (limits_.any() && all_kept(report_.unfold.limits)) return false;
    const UnfoldReport& result = report_.unfold;
    const EdgeStrain after =
        result.unmatched_strain.value_or(result.unlimited_strain.value_or(result.strain));
    const double before = report_.unfold_before.strain.rms;
    return after.rms - before > std::max(same * before, not_measurable);
  }

  /// The result is the input though its pattern misses the limits, with the one that misses them
  /// least.
  void keep_missed_design(const Patch& patch) {
    if (coarse_search_.design_misses)
      within_limits_ = unfolded_within_limits(work_patch(patch), shares_.design);
    if (within_limits_) report_.as_designed = std::move(*within_limits_);
    take_design(patch, StopReason::design_kept);
  }

  /// Drops what evolving made; the history says what was tried.
  void return_to_design(const Patch& patch) {
    report_.rejected = report_.unfold.strain;
    EvolveResult tried = std::move(report_.evolve.result);
    keep_missed_design(patch);
    report_.evolve.result.history = std::move(tried.history);
    report_.evolve.result.threads = tried.threads;
    report_.evolve.result.seconds = tried.seconds;
  }

  /// Auto ends by its estimate of the strain. Where the pattern has a little more than that, it is
  /// run again with tighter limits.
  void evolve_to_aim(const Patch& patch) {
    Method method = method_;
    for (int run = 1;; ++run) {
      evolve_and_unfold(patch, method);
      const double share = share_of_limits(checks_of_aim(
          work_patch(patch).with_positions(report_.evolve.result.positions), report_.unfold));
      const bool may_try =
          report_.evolve.result.stop == StopReason::strain_met && run < effort_.runs;
      if (!aim_.any() || share >= 1.0 || !may_try) break;
      method = tightened(method, aim_, share);
    }
    report_.evolve.method = method_;
    go_back_if_limited(patch);
    // Auto ends by an estimate: what counts is the pattern.
    StopReason& stop = report_.evolve.result.stop;
    if (stop == StopReason::smooth_limit && limits_.any() && all_kept(report_.unfold.limits))
      stop = StopReason::strain_met;
  }

  EvolveReport evolved(const Patch& patch, const Method& method, const Context& context) const {
    const Patch& work = work_patch(patch);
    if (const auto whole = fold_ ? symmetric_whole(work, *fold_) : std::nullopt) {
      const Constraints& constraints = remeshed_ ? remeshed_->constraints : options_.constraints;
      EvolveReport report = evolve_half(work, *whole, method, stopping_, constraints, context);
      return with_original_compared(std::move(report), patch);
    }
    if (remeshed_) return evolve_remeshed(patch, *remeshed_, method, stopping_, context);
    return evolve_patch(patch, method, stopping_, options_.constraints, context);
  }

  void evolve_and_unfold(const Patch& patch, const Method& method) {
    const Patch& work = work_patch(patch);
    report_.evolve = evolved(patch, method, parts_.next(shares_.evolution));
    const Patch processed = work.with_positions(report_.evolve.result.positions);
    if (before_) {
      report_.unfold_before = *before_;
      report_.unfold = unfolded_within_limits(processed, shares_.pattern);
      return;
    }
    auto [before, after] =
        unfold_both(work, processed, options_.unit, with_limits(),
                    report_.evolve.result.threads > 1, parts_.next(shares_.pattern));
    report_.unfold_before = report_.as_designed = std::move(before);
    before_ = report_.unfold_before;
    report_.unfold = with_limits_checked(processed, std::move(after));
  }

  /// A border that moves is left where it is.
  void go_back_if_limited(const Patch& patch) {
    if (!aim_.any() || !limits_.any() || std::get<Auto>(method_).border.moves()) return;
    EvolvedPattern found = {std::move(report_.evolve), std::move(report_.unfold)};
    const double share = go_back(work_patch(patch), found, runs_on(patch));
    report_.evolve = std::move(found.evolve);
    report_.unfold = std::move(found.unfold);
    if (share < 1.0) measure_again(patch);
  }

  /// What a search for the least change runs.
  SurfaceRuns runs_on(const Patch& patch) {
    constexpr double share = 0.2;  // of what is left
    const Auto& method = std::get<Auto>(method_);
    const bool near = method.prefer == Prefer::near;
    const double b0 = near ? 0.0 : design_bending(work_patch(patch));
    SurfaceRuns runs;
    const bool is_slow = work_patch(patch).vertex_count() > k_large && limits_.bounds_edges();
    runs.effort = is_slow ? k_effort_of_large : effort_;
    runs.evolved = [this, &patch, led = method](const SurfaceLimits& limits) mutable {
      led.max_strain = 0.0;
      led.max_rms_strain = limits.rms_strain;
      led.max_deviation = limits.max_deviation;
      return evolved(patch, led, parts_.next(share));
    };
    runs.unfolded = [this](const Patch& surface) { return unfolded_within_limits(surface, share); };
    runs.stretched_least = [this](const Patch& surface) {
      return unfolded(surface, without_limits(), k_share_of_plain);
    };
    runs.is_form_good = [this, near, b0, &patch, most = method.max_bending](const auto& positions) {
      stop_if_cancelled(context_);
      return near || fairness_beside(work_patch(patch), b0, positions).is_smooth_within(most);
    };
    // Half way between two places on a curved border is beside it.
    runs.may_be_between = method.border.rule != BorderFreedom::Rule::slide;
    return runs;
  }

  void take(EvolvedPattern found, const Patch& patch) {
    report_.unfold_before = *before_;
    report_.evolve = std::move(found.evolve);
    report_.evolve.method = method_;
    report_.unfold = std::move(found.unfold);
    measure_again(patch);
  }

  /// Whether a pattern may keep the limits where the surface's estimate does not: that says little
  /// of the largest strain, and the pattern has less rms than it tells.
  bool seeks_least_change() const {
    const auto* method = std::get_if<Auto>(&method_);
    return method != nullptr && method->prefer == Prefer::smooth &&
           std::isinf(method->max_deviation) && !design_serves_ && aim_.any() &&
           (options_.limits.bounds_edges() || (options_.limits.any() && !options_.method));
  }

  std::optional<EvolvedPattern> nearest_within_limits(const Patch& patch, const SurfaceRuns& runs) {
    return least_change(work_patch(patch), within_limits_ ? *within_limits_ : report_.as_designed,
                        before_->strain.rms, runs, coarse_search_.gone);
  }

  bool changes_least(const Patch& patch) {
    if (!seeks_least_change()) return false;
    auto found = nearest_within_limits(patch, runs_on(patch));
    if (!found) return false;
    take(std::move(*found), patch);
    return true;
  }

  /// How far the form may go for the least strain, or for limits, where no method was asked for
  /// that is led otherwise.
  std::optional<double> tolerance() const {
    const auto* method = std::get_if<Auto>(&method_);
    const bool is_led = method == nullptr || method->prefer != Prefer::smooth ||
                        method->max_bending > 0.0 || !aim_.any() ||
                        (options_.method && !options_.limits.any());
    if (is_led || std::isinf(method->max_deviation)) return std::nullopt;
    return method->max_deviation;
  }

  /// True if a tolerance was given: the result is the least change for the limits where that is
  /// within it, or else the least strain that is.
  bool stays_near(const Patch& patch) {
    const std::optional<double> distance = tolerance();
    if (!distance) return false;
    constexpr double nothing = 1e-3;  // of the tolerance
    const Tolerance within{*distance - spent_};
    if (within.distance <= nothing * *distance) {
      keep_missed_design(patch);
      return true;
    }
    const Patch& work = work_patch(patch);
    const SurfaceRuns runs = runs_on(patch);
    std::optional<EvolvedPattern> found =
        limits_.any() ? nearest_within_limits(patch, runs) : std::nullopt;
    if (!found || !within.allows(work, found->evolve.result.positions)) {
      found = least_strain_within(work, within, before_->strain.rms, runs);
      found->unfold = runs.unfolded(work.with_positions(found->evolve.result.positions));
    }
    take(std::move(*found), patch);
    if (is_worse_than_design()) return_to_design(patch);
    return true;
  }

  void measure_again(const Patch& patch) {
    const Patch& work = work_patch(patch);
    const Patch now = work.with_positions(report_.evolve.result.positions);
    report_.evolve.after = measure_patch(now, context_);
    report_.evolve.deviation = measure_deviation(work, now.positions());
    report_.evolve.border = measure_border_change(work, now.positions());
    report_.evolve.fairness = measure_fairness(work, now.positions());
    compare_with_original(patch);
  }

  /// Where vertices were removed, the result is compared with the surface that had all of them.
  void compare_with_original(const Patch& original) {
    report_.evolve = with_original_compared(std::move(report_.evolve), original);
  }

  EvolveReport with_original_compared(EvolveReport report, const Patch& original) const {
    if (!remeshed_ || remeshed_->patch.vertex_count() == original.vertex_count()) return report;
    const Patch now = remeshed_->patch.with_positions(report.result.positions);
    report.remeshed_from = OriginalSize{original.vertex_count(), original.triangles().size()};
    report.deviation = measure_surface_deviation(original, now.mesh());
    report.fairness = measure_fairness(original, now);
    return report;
  }

  const FlattenOptions& options_;
  SearchEffort effort_;
  const Context& context_;
  PartsOfJob parts_;
  StrainLimits limits_;
  WorkShares shares_;
  Method method_;
  Stopping stopping_;
  StrainLimits aim_;
  std::optional<RemeshedPatch> remeshed_;
  std::vector<std::array<Index, 2>> free_edges_;  // of the work patch
  std::optional<std::array<Index, 2>> fold_;      // likewise
  FlattenReport report_;
  double spent_ = 0.0;                  // of a tolerance, by smoothing first
  bool design_serves_ = false;          // its pattern keeps the limits
  std::optional<UnfoldReport> before_;  // the input without limits, where that is known already
  CoarseSearch coarse_search_;
  std::optional<UnfoldReport> within_limits_;  // the input's pattern that misses them least
};

/// What keeping limits would do, with what this run did in the place of its estimate.
std::vector<Way> ways_beside(const FlattenReport& report, const FlattenOptions& options,
                             const Context& context) {
  // More trials move the estimates by less than a coarse mesh does.
  constexpr SearchEffort little = {
      .runs = 2, .trials = 1, .first_halvings = 3, .last_halvings = 3, .halvings = 3};
  const auto run = [&](const Patch& coarse, const FlattenOptions& job, const Context& of_job) {
    return Flattening(job, little, of_job).run(coarse, {});
  };
  const UnfoldReport& design = report.as_designed;
  return with_result(
      find_ways(report.input, options, {design.strain, least_strain(design)}, run, context),
      report);
}

}  // namespace

bool FlattenOptions::may_change() const {
  return method || limits_of(*this).any() ||
         (as_needed.max_deviation > 0.0 && !std::isinf(as_needed.max_deviation));
}

FlattenReport with_turned(FlattenReport report, bool turned) {
  for (UnfoldReport* unfold : {&report.unfold, &report.unfold_before, &report.as_designed})
    unfold->turned = turned;
  return report;
}

FlattenReport flatten(const Patch& patch, std::string name, const FlattenOptions& options,
                      const Context& context) {
  check_request(options);
  FlattenReport report = Flattening(options, {}, context).run(patch, std::move(name));
  const bool may_move = options.as_needed.max_deviation > 0.0;
  if (options.ways && !options.method && may_move)
    report.ways = ways_beside(report, options, context);
  report_progress(context, {"unfolding", 1.0});
  return report;
}

}  // namespace planish
