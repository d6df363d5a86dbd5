#include <algorithm>
#include <cmath>
#include <utility>

#include <planish/flatten/flatten.h>

#include "core/job.h"
#include "flatten/check_request.h"
#include "flatten/choices/coarse_job.h"
#include "flatten/choices/find_ways.h"
#include "flatten/steps/design.h"
#include "flatten/steps/least_change.h"
#include "flatten/steps/task.h"
#include "flatten/steps/unfold_patch.h"
#include "measure/smoothed.h"

namespace planish {

namespace {

/// Of the work that is left, how much a part takes: as measured on patches of 60,000 vertices.
struct WorkShares {
  double design, evolution, pattern;
};

constexpr double k_share_of_plain = 0.03;  // of laying the design flat once more without limits
constexpr double k_share_of_trial = 0.2;   // of a surface that a search tries

/// Limits take more than half of the work where they have to be searched for.
WorkShares shares_with(const StrainLimits& limits) {
  return limits.any() ? WorkShares{0.25, 0.2, 0.25} : WorkShares{0.15, 0.87, 0.95};
}

/// Searches of larger patches begin where that of a coarse mesh ended. Where edges have limits they
/// try less: each pattern takes tens of seconds on 60,000 vertices.
constexpr std::size_t k_large = 12'000, k_coarse_vertices = 3'000;
constexpr SearchEffort k_effort_of_large = {
    .runs = 3, .trials = 2, .first_halvings = 2, .last_halvings = 4, .halvings = 4};

/// What all steps are given.
struct Work {
  const Task& task;
  const Design& design;
  const Context& context;
  PartsOfJob& parts;
  WorkShares shares;
};

UnfoldReport unfold_plain(const Patch& surface, const Work& work, double share) {
  return unfold_patch(surface, work.task.options.unit,
                      {.least_stretch = true,
                       .fold = work.design.fold,
                       .symmetric_in = work.design.constraints.symmetric_in},
                      work.parts.next(share));
}

/// With limits and matched seams.
UnfoldOptions as_asked(const Work& work) {
  const FlattenOptions& options = work.task.options;
  UnfoldOptions how{.least_stretch = true,
                    .fold = work.design.fold,
                    .symmetric_in = work.design.constraints.symmetric_in};
  how.match_seams = options.match_seams;
  how.match_if_possible = options.match_if_possible;
  how.free_edges = work.design.free_edges;
  how.seam_lengths = options.seam_lengths;
  how.limits = work.task.limits;
  // Where a method was asked for, its surface is led to the limit, not its pattern.
  if (options.method) how.limits.rms = 0.0;
  return how;
}

UnfoldReport with_limits_checked(UnfoldReport report, const Patch& surface, const Work& work) {
  report.limits = check_limits(surface, report.pattern.positions, work.task.limits);
  return report;
}

UnfoldReport unfold_as_asked(const Patch& surface, const Work& work, double share) {
  return with_limits_checked(
      unfold_patch(surface, work.task.options.unit, as_asked(work), work.parts.next(share)),
      surface, work);
}

/// As asked, with the stretch spread unless least stretch was asked for.
UnfoldReport unfold_as_written(const Patch& surface, const Work& work, double share) {
  UnfoldOptions how = as_asked(work);
  how.least_stretch = work.task.options.least_stretch || work.task.options.method;
  return with_limits_checked(
      unfold_patch(surface, work.task.options.unit, how, work.parts.next(share)), surface, work);
}

/// What a pattern has of the aim. Strain is measured against the surface that it is made from.
std::vector<LimitCheck> checks_of_aim(const Patch& surface, const UnfoldReport& report,
                                      const Task& task) {
  if (task.limits.any() || !task.aim.any()) return report.limits;
  return check_limits(surface, report.pattern.positions, task.aim);
}

/// The patterns of the design.
struct DesignPatterns {
  UnfoldReport plain;                 ///< of least stretch, unless the design is kept as it is
  std::optional<UnfoldReport> asked;  ///< within limits; none where plain is far from keeping them
  bool keeps_aim = false;             ///< by `asked`
  std::optional<double> coarse_gone;  ///< as of CoarseSearch

  /// Where it misses the limits, a pattern evened out for them is no measure of the design.
  UnfoldReport shown(const Work& work) const {
    if (asked && (keeps_aim || !work.task.limits.any())) return *asked;
    return with_limits_checked(plain, work.design.patch, work);
  }
};

/// Lays the design flat as asked, and with least stretch: without limits and matching these are
/// the same.
/// @param plain that of least stretch, where it is known
DesignPatterns lay_out(const Work& work, std::optional<UnfoldReport> plain = {}) {
  const Task& task = work.task;
  const Patch& patch = work.design.patch;
  DesignPatterns patterns;
  patterns.asked = unfold_as_written(patch, work, work.shares.design);
  patterns.keeps_aim = all_kept(checks_of_aim(patch, *patterns.asked, task));
  if (!task.limits.any() && !task.options.match_seams)
    patterns.plain = *patterns.asked;
  else
    patterns.plain = plain ? std::move(*plain) : unfold_plain(patch, work, k_share_of_plain);
  return patterns;
}

/// The report of a design that is the result with its pattern.
FlattenReport design_kept(const Work& work, DesignPatterns patterns, StopReason reason) {
  // One that misses the limits is shown with the pattern that misses them least.
  if (!patterns.asked)
    patterns.asked = unfold_as_asked(work.design.patch, work, work.shares.design);
  FlattenReport report;
  report.evolve = design_as_it_is(work.design, work.task, reason);
  report.unfold = report.design_pattern = std::move(*patterns.asked);
  report.design_least_stretch = std::move(patterns.plain);
  return report;
}

/// The report of a surface that was found.
FlattenReport design_changed(const Work& work, const DesignPatterns& patterns,
                             EvolvedPattern found) {
  FlattenReport report;
  report.evolve = std::move(found.evolve);
  report.evolve.method = work.task.method;
  report.unfold = std::move(found.unfold);
  report.design_least_stretch = patterns.plain;
  report.design_pattern = patterns.shown(work);
  return report;
}

EvolvedPattern measured_again(const Work& work, EvolvedPattern found) {
  found.evolve = measured_again(std::move(found.evolve), work.design, work.context);
  return found;
}

/// Whether evolving stretched the pattern of least stretch by more than is worth a word. One that
/// keeps the limits is not worse, as these are what was asked for.
bool is_worse_than_design(const FlattenReport& report, const StrainLimits& limits) {
  constexpr double same = 0.02, not_measurable = 1e-6;
  if (limits.any() && all_kept(report.unfold.limits)) return false;
  const double before = least_strain(report.design_least_stretch).rms;
  return least_strain(report.unfold).rms - before > std::max(same * before, not_measurable);
}

/// The design in the place of a surface that stretches more; the history says what was tried.
FlattenReport unless_worse(const Work& work, DesignPatterns patterns, FlattenReport tried) {
  if (!is_worse_than_design(tried, work.task.limits)) return tried;
  FlattenReport report = design_kept(work, std::move(patterns), StopReason::design_kept);
  report.rejected = tried.unfold.strain;
  report.evolve.result.history = std::move(tried.evolve.result.history);
  report.evolve.result.threads = tried.evolve.result.threads;
  report.evolve.result.seconds = tried.evolve.result.seconds;
  return report;
}

/// What a search for the least change runs.
SurfaceRuns runs_for(const Work& work) {
  const Auto& method = std::get<Auto>(work.task.method);
  const Patch& patch = work.design.patch;
  const bool is_slow = patch.vertex_count() > k_large && work.task.limits.bounds_edges();
  SurfaceRuns runs;
  runs.effort = is_slow ? k_effort_of_large : work.task.effort;
  runs.bending = work.design.measured.bending;
  runs.evolved = [&work, led = method](const StrainLimits& limits, double max_deviation) mutable {
    led.limits = limits;
    led.max_deviation = max_deviation;
    return evolve_design(work.design, led, work.task.stopping, work.parts.next(k_share_of_trial));
  };
  runs.unfolded = [&work](const Patch& surface) {
    return unfold_as_asked(surface, work, k_share_of_trial);
  };
  runs.stretched_least = [&work](const Patch& surface) {
    return unfold_plain(surface, work, k_share_of_plain);
  };
  runs.is_form_good = [&work, &method](const std::vector<Vec3>& positions) {
    stop_if_cancelled(work.context);
    return method.prefer == Prefer::near ||
           fairness_beside(work.design.patch, work.design.measured.bending, positions)
               .is_smooth_within(method.max_bending);
  };
  // Half way between two places on a curved border is beside it.
  runs.may_be_between = method.border.rule != BorderFreedom::Rule::slide;
  return runs;
}

/// The least change with which a pattern keeps the limits; none where none was found. Its figures
/// are to be measured again.
std::optional<EvolvedPattern> nearest_within_limits(const Work& work,
                                                    const DesignPatterns& patterns) {
  return least_change(work.design.patch, patterns.asked ? *patterns.asked : patterns.shown(work),
                      patterns.plain.strain.rms, runs_for(work), patterns.coarse_gone);
}

/// Laid out as the design is. With less rms there is less to spread: where a sheet would have to
/// take more on 99 % of the area than of the design, the pattern of least stretch that needs no
/// more.
UnfoldReport unfold_within_tolerance(const Patch& surface, const Work& work,
                                     const DesignPatterns& patterns) {
  UnfoldReport spread = unfold_as_written(surface, work, k_share_of_trial);
  UnfoldOptions how = as_asked(work);
  how.limits.p99 = patterns.asked->strain.p99;
  if (work.task.options.least_stretch || spread.strain.p99 <= how.limits.p99) return spread;
  UnfoldReport even =
      unfold_patch(surface, work.task.options.unit, how, work.parts.next(k_share_of_trial));
  const bool is_better =
      even.strain.p99 < spread.strain.p99 && (!even.pattern.overlaps || spread.pattern.overlaps);
  return is_better ? with_limits_checked(std::move(even), surface, work) : spread;
}

/// The least change for the limits where that is within the tolerance, or else the least strain
/// that is.
FlattenReport stay_within(const Work& work, const DesignPatterns& patterns, double distance) {
  constexpr double nothing = 1e-3;  // of the tolerance
  const Patch& patch = work.design.patch;
  const double spent = work.design.smoothed ? work.design.smoothed->moved.max : 0.0;
  const Tolerance within{distance - spent};
  if (within.distance <= nothing * distance)
    return design_kept(work, patterns, StopReason::design_kept);
  std::optional<EvolvedPattern> found;
  if (work.task.limits.any()) found = nearest_within_limits(work, patterns);
  const auto is_within = [&](const std::vector<Vec3>& positions) {
    return within.use(patch, work.design.measured.bending, positions).most() <= 1.0;
  };
  if (!found || !is_within(found->evolve.result.positions)) {
    const SurfaceRuns runs = runs_for(work);
    found = least_strain_within(patch, within, patterns.plain.strain.rms, runs);
    const Patch surface = patch.with_positions(found->evolve.result.positions);
    found->unfold = work.task.limits.any() ? runs.unfolded(surface)
                                           : unfold_within_tolerance(surface, work, patterns);
  }
  return unless_worse(work, patterns,
                      design_changed(work, patterns, measured_again(work, std::move(*found))));
}

/// Runs the method. Auto ends by its estimate of the strain: where the pattern has a little more
/// than that, it is run again with tighter limits.
template <class Unfold>
EvolvedPattern evolve_to_aim(const Work& work, const Unfold& unfolded) {
  const Task& task = work.task;
  Method method = task.method;
  for (int run = 1;; ++run) {
    EvolvedPattern found;
    found.evolve =
        evolve_design(work.design, method, task.stopping, work.parts.next(work.shares.evolution));
    const Patch surface = work.design.patch.with_positions(found.evolve.result.positions);
    found.unfold = unfolded(surface, found.evolve);
    const double share = headroom(checks_of_aim(surface, found.unfold, task));
    const bool may_try =
        found.evolve.result.stop == StopReason::strain_met && run < task.effort.runs;
    if (!task.aim.any() || share >= 1.0 || !may_try) return found;
    method = task.tightened(method, share);
  }
}

/// Goes back to where the pattern still keeps the limits. A border that moves is left where it is.
EvolvedPattern backtrack(const Work& work, EvolvedPattern found) {
  const bool may = work.task.limits.any() && !std::get<Auto>(work.task.method).border.moves();
  if (!may || go_back(work.design.patch, found, runs_for(work)) == 1.0) return found;
  return measured_again(work, std::move(found));
}

/// Auto ends by an estimate: what counts is the pattern.
StopReason stop_of(const EvolvedPattern& found, const StrainLimits& limits) {
  const StopReason stop = found.evolve.result.stop;
  const bool is_met =
      stop == StopReason::smooth_limit && limits.any() && all_kept(found.unfold.limits);
  return is_met ? StopReason::strain_met : stop;
}

/// Where no pattern decides when the work is done, the design's is laid flat beside the result's.
FlattenReport evolve_without_aim(const Work& work) {
  DesignPatterns patterns;
  EvolvedPattern found = evolve_to_aim(work, [&](const Patch& surface, const EvolveReport& made) {
    auto [before, after] =
        unfold_both(work.design.patch, surface, work.task.options.unit, as_asked(work),
                    made.result.threads > 1, work.parts.next(work.shares.pattern));
    patterns.plain = std::move(before);
    return with_limits_checked(std::move(after), surface, work);
  });
  patterns.asked = patterns.plain;
  found.evolve.result.stop = stop_of(found, work.task.limits);
  FlattenReport report = design_changed(work, patterns, std::move(found));
  report.design_pattern = patterns.plain;
  return unless_worse(work, std::move(patterns), std::move(report));
}

FlattenReport evolve_with_aim(const Work& work, DesignPatterns patterns) {
  EvolvedPattern found =
      backtrack(work, evolve_to_aim(work, [&](const Patch& surface, const EvolveReport&) {
                  return unfold_as_asked(surface, work, work.shares.pattern);
                }));
  found.evolve.result.stop = stop_of(found, work.task.limits);
  const UnfoldReport& unfold = found.unfold;
  // Evolving was to part what overlaps, of a pattern that kept the limits from the beginning.
  if (patterns.keeps_aim && (unfold.pattern.overlaps || !all_kept(unfold.limits)))
    return design_kept(work, std::move(patterns), StopReason::strain_met);
  FlattenReport report = design_changed(work, patterns, std::move(found));
  return unless_worse(work, std::move(patterns), std::move(report));
}

FlattenReport flattened(const Patch& patch, const FlattenOptions& options,
                        const SearchEffort& effort, const Context& context);

/// What the search for the least change came to on a coarse mesh.
struct CoarseSearch {
  std::optional<double> gone;  ///< of the design's strain, by the surface that was found
  bool design_misses = false;  ///< the pattern of the design is far from keeping the limits
};

CoarseSearch search_on_coarse_mesh(const Work& work, const EdgeStrain& strain) {
  constexpr double far = 0.8;  // of the limits that strain may have
  CoarseSearch search;
  const ThreadPool pool(work.context);
  const auto coarse = coarse_job(work.design.patch, work.task.options, k_coarse_vertices,
                                 {strain, strain}, pool, work.context);
  if (!coarse) return search;
  FlattenOptions job = coarse->options;
  job.limits = coarse->strain.scaled(work.task.limits);
  Context context = work.context;
  context.on_progress = {};
  try {
    const FlattenReport found = flattened(coarse->patch, job, {}, context);
    search.design_misses =
        headroom(check_limits(coarse->patch, found.design_pattern.pattern.positions, job.limits)) <
        far;
    if (all_kept(found.unfold.limits))
      search.gone = 1.0 - least_strain(found.unfold).rms / found.design_least_stretch.strain.rms;
  } catch (const Error&) {
    // The search begins as that of a small patch does.
  }
  return search;
}

/// As lay_out(), where a coarse mesh may tell that the pattern as asked is not worth its time.
DesignPatterns lay_out_for_aim(const Work& work) {
  const bool is_searched = work.design.patch.vertex_count() > k_large && work.task.limits.any() &&
                           work.task.seeks_least_change();
  if (!is_searched) return lay_out(work);
  UnfoldReport plain = unfold_plain(work.design.patch, work, k_share_of_plain);
  const CoarseSearch coarse = search_on_coarse_mesh(work, plain.strain);
  DesignPatterns patterns;
  if (coarse.design_misses)
    patterns.plain = std::move(plain);
  else
    patterns = lay_out(work, std::move(plain));
  patterns.coarse_gone = coarse.gone;
  return patterns;
}

/// The least that has to be done: nothing, where the design's pattern keeps the aim. One that keeps
/// the limits, but overlaps itself, is no pattern to cut: another form may have a better one.
FlattenReport changed_as_needed(const Work& work) {
  const Task& task = work.task;
  if (task.keeps_design()) return design_kept(work, lay_out(work), StopReason::design_kept);
  if (!task.aim.any()) return evolve_without_aim(work);
  DesignPatterns patterns = lay_out_for_aim(work);
  if (patterns.keeps_aim && !(task.limits.any() && patterns.asked->pattern.overlaps))
    return design_kept(work, std::move(patterns), StopReason::strain_met);
  if (const auto distance = task.tolerance()) return stay_within(work, patterns, *distance);
  if (task.seeks_least_change() && !patterns.keeps_aim) {
    if (auto found = nearest_within_limits(work, patterns))
      return design_changed(work, patterns, measured_again(work, std::move(*found)));
  }
  return evolve_with_aim(work, std::move(patterns));
}

FlattenReport flattened(const Patch& patch, const FlattenOptions& options,
                        const SearchEffort& effort, const Context& context) {
  report_progress(context, {"measuring", 0.0});
  const Task task(options, effort);
  Design design = prepare_design(patch, task, context);
  PartsOfJob parts(context);
  FlattenReport report =
      changed_as_needed({task, design, context, parts, shares_with(task.limits)});
  report.evolve = compared_with_original(std::move(report.evolve), design);
  report.material = options.material;
  report.processed = design.patch.with_positions(report.evolve.result.positions);
  report.input = std::move(design.patch);
  report.source = std::move(design.source);
  report.cautions = std::move(design.cautions);
  return report;
}

/// What keeping limits would do, with what this run did in the place of its estimate.
std::vector<Way> ways_beside(const FlattenReport& report, const FlattenOptions& options,
                             const Context& context) {
  // More trials move the estimates by less than a coarse mesh does.
  constexpr SearchEffort little = {
      .runs = 2, .trials = 1, .first_halvings = 3, .last_halvings = 3, .halvings = 3};
  const auto run = [&](const Patch& coarse, const FlattenOptions& job, const Context& of_job) {
    return flattened(coarse, job, little, of_job);
  };
  const UnfoldReport& design = report.design_pattern;
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
  for (UnfoldReport* unfold :
       {&report.unfold, &report.design_least_stretch, &report.design_pattern})
    unfold->turned = turned;
  return report;
}

FlattenReport flatten(const Patch& patch, std::string name, const FlattenOptions& options,
                      const Context& context) {
  check_request(options);
  FlattenReport report = flattened(patch, options, {}, context);
  report.name = std::move(name);
  const bool may_move = options.as_needed.max_deviation > 0.0;
  if (options.ways && !options.method && may_move)
    report.ways = ways_beside(report, options, context);
  report_progress(context, {"unfolding", 1.0});
  return report;
}

}  // namespace planish
