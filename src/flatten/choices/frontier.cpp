#include <algorithm>
#include <cstddef>
#include <utility>

#include <planish/flatten/frontier.h>

#include "core/job.h"

namespace planish {

namespace {

constexpr double k_most_points = 1000;

/// What flatten() is asked for, for every point of the curve.
std::vector<FlattenOptions> stops_of(const FrontierOptions& options, double rms_strain) {
  const FlattenOptions common = {.unit = options.unit, .constraints = options.constraints};
  std::vector<FlattenOptions> stops;
  for (const double limit : frontier_limits(rms_strain, options.points)) {
    const auto usual = std::find(k_candidate_strains.begin(), k_candidate_strains.end(), limit);
    if (limit == 0.0) {
      stops.push_back(preset_options(k_candidates, common));
    } else if (usual != k_candidate_strains.end()) {
      const auto place = static_cast<int>(usual - k_candidate_strains.begin());
      stops.push_back(preset_options(place + 2, common));
    } else {
      stops.push_back(common);
      stops.back().limits.rms = limit;
    }
  }
  if (options.limits.any()) {
    stops.push_back(common);
    stops.back().limits = options.limits;
  }
  return stops;
}

Candidate candidate_of(const ComparedMethod& compared) {
  const EvolveReport& evolve = *compared.evolve;
  return {.method = compared.run.method,
          .stop = evolve.result.stop,
          .sweeps = evolve.result.history.size(),
          .seconds = evolve.result.seconds,
          .strain = compared.unfold->strain,
          .deviation = evolve.deviation,
          .flattenable = evolve.after.flattenable,
          .fairness = evolve.fairness};
}

/// Does the work of frontier(), one run after the other.
class FrontierRuns {
 public:
  FrontierRuns(const Patch& patch, FrontierReport& report, const Context& context)
      : patch_(patch), report_(report), parts_(context) {}

  void add_design(const FrontierOptions& options) {
    const FlattenOptions as_designed =
        preset_options(1, {.unit = options.unit, .constraints = options.constraints});
    report_.design =
        flatten(patch_, report_.name, as_designed, parts_.next(0.05)).candidates().front();
  }

  /// @param share of the work that is left, 0 to 1: the same for every stop
  void add_curve(const std::vector<FlattenOptions>& stops, double share) {
    const double part = share / static_cast<double>(stops.size());
    for (std::size_t k = 0; k < stops.size(); ++k)
      add_stop(stops[k], parts_.next(part / (1.0 - static_cast<double>(k) * part)));
    std::stable_sort(
        report_.curve.begin(), report_.curve.end(),
        [](const Candidate& a, const Candidate& b) { return a.deviation.rms < b.deviation.rms; });
  }

  void add_others(const FrontierOptions& options) {
    if (options.others.empty()) return;
    const CompareReport compared = compare(patch_, report_.name, options.others,
                                           {options.unit, options.constraints}, parts_.next(1.0));
    for (const ComparedMethod& run : compared.runs) {
      if (run.failure) {
        report_.failures.push_back({run.run.method, *run.failure});
      } else {
        report_.others.push_back(candidate_of(run));
      }
    }
  }

 private:
  void add_stop(const FlattenOptions& stop, const Context& context) {
    try {
      const FlattenReport made = flatten(patch_, report_.name, stop, context);
      if (!made.evolve.fairness.unchanged) report_.curve.push_back(made.candidates().back());
    } catch (...) {
      report_.failures.push_back({stop.method.value_or(stop.as_needed), current_failure()});
    }
  }

  const Patch& patch_;
  FrontierReport& report_;
  PartsOfJob parts_;
};

void check(const FrontierOptions& options) {
  if (options.points) check_range("points", *options.points, {2.0, k_most_points});
  require(options.limits);
}

}  // namespace

std::optional<std::size_t> FrontierReport::first_within_limit() const {
  if (!limits.any()) return std::nullopt;
  const auto found = std::find_if(curve.begin(), curve.end(), [&](const Candidate& point) {
    return limits.kept_by(point.strain);
  });
  if (found == curve.end()) return std::nullopt;
  return static_cast<std::size_t>(found - curve.begin());
}

FrontierReport frontier(const Patch& patch, std::string name, const FrontierOptions& options,
                        const Context& context) {
  check(options);
  FrontierReport report;
  report.name = std::move(name);
  report.unit = options.unit;
  report.limits = options.limits;
  report.cautions = find_cautions(patch);
  FrontierRuns runs(patch, report, context);
  runs.add_design(options);
  runs.add_curve(stops_of(options, report.design.strain.rms), options.others.empty() ? 1.0 : 0.5);
  runs.add_others(options);
  mark_dominated(report);
  return report;
}

}  // namespace planish
