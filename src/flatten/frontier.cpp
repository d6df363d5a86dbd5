#include <algorithm>
#include <cmath>
#include <utility>

#include <planish/flatten/frontier.h>

#include "core/job.h"

namespace planish {

namespace {

constexpr double k_most_points = 1000;

std::vector<CompareRun> runs_of(const FrontierOptions& options, double rms_strain) {
  std::vector<CompareRun> runs;
  const auto add = [&](const Auto& method) { runs.push_back({method, usual_stopping(method)}); };
  for (const double limit : frontier_limits(rms_strain, options.points)) {
    add(limit > 0.0 ? Auto{.max_rms_strain = limit, .prefer = Prefer::smooth}
                    : Auto{.prefer = Prefer::flat});
  }
  if (options.limit) add({.max_strain = *options.limit, .prefer = Prefer::smooth});
  runs.insert(runs.end(), options.others.begin(), options.others.end());
  return runs;
}

FrontierPoint point_of(const ComparedMethod& compared) {
  const EvolveReport& evolve = *compared.evolve;
  return {compared.run.method,      evolve.result.stop,      evolve.result.history.size(),
          evolve.result.seconds,    compared.unfold->strain, evolve.deviation,
          evolve.after.flattenable, evolve.fairness};
}

void check(const FrontierOptions& options) {
  if (options.points) check_range("points", *options.points, {2.0, k_most_points});
  if (options.limit) check_range("limit", *options.limit, {std::nextafter(0.0, 1.0), 1.0});
}

}  // namespace

std::optional<std::size_t> FrontierReport::first_within_limit() const {
  if (!limit) return std::nullopt;
  const auto found = std::find_if(curve.begin(), curve.end(), [&](const FrontierPoint& point) {
    return point.strain.max <= *limit;
  });
  if (found == curve.end()) return std::nullopt;
  return static_cast<std::size_t>(found - curve.begin());
}

FrontierReport frontier(const Patch& patch, std::string name, const FrontierOptions& options,
                        const Context& context) {
  check(options);
  PartsOfJob parts(context);
  const UnfoldReport before = unfold_patch(patch, options.unit, {}, parts.next(0.05));
  CompareReport compared = compare(patch, std::move(name), runs_of(options, before.strain.rms),
                                   {options.unit, options.constraints}, parts.next(1.0));

  FrontierReport report;
  report.name = std::move(compared.name);
  report.unit = options.unit;
  report.before = before.strain;
  report.bending_ratio_before = measure_fairness(patch, patch).bending_ratio;
  report.limit = options.limit;
  const std::size_t on_curve = compared.runs.size() - options.others.size();
  for (std::size_t i = 0; i < compared.runs.size(); ++i) {
    const ComparedMethod& run = compared.runs[i];
    if (run.failure) {
      report.failures.push_back({run.run.method, *run.failure});
    } else {
      (i < on_curve ? report.curve : report.others).push_back(point_of(run));
    }
  }
  std::stable_sort(report.curve.begin(), report.curve.end(),
                   [](const FrontierPoint& a, const FrontierPoint& b) {
                     return a.deviation.rms < b.deviation.rms;
                   });
  mark_dominated(report);
  return report;
}

}  // namespace planish
