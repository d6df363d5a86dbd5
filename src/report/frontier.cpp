#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <planish/report/frontier.h>

#include "core/math.h"
#include "core/number_text.h"

namespace planish {

namespace {

// Down to there limits of strain are asked for: less nobody can measure on a sheet.
constexpr double k_least_limit = 0.001;
constexpr double k_no_strain = 1e-9;
constexpr double k_most_points = 1000;

std::vector<CompareRun> runs_of(const FrontierOptions& options, double largest_strain) {
  std::vector<double> limits = frontier_limits(largest_strain, options.points);
  if (options.limit) limits.push_back(*options.limit);
  std::sort(limits.begin(), limits.end(), std::greater<>());
  std::vector<CompareRun> runs;
  for (const double limit : limits) {
    const Method method = Auto{.max_strain = limit, .prefer = Prefer::near};
    runs.push_back({method, usual_stopping(method)});
  }
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
  check_range("points", options.points, {2.0, k_most_points});
  if (options.limit) check_range("limit", *options.limit, {std::nextafter(0.0, 1.0), 1.0});
}

void append_point(std::string& csv, const FrontierPoint& point) {
  csv += std::string(name_of(point.method)) + ',';
  const auto* options = std::get_if<Auto>(&point.method);
  if (options != nullptr) append_number(csv, options->max_strain);
  for (const double value :
       {point.strain.rms, point.strain.p99, point.strain.max, point.deviation.rms,
        point.deviation.max, point.deviation.rms_over_diagonal}) {
    csv += ',';
    append_number(csv, value);
  }
  const auto yes_or_no = [](bool yes) { return yes ? ",1" : ",0"; };
  csv += yes_or_no(point.flattenable);
  for (const auto& figure : {point.fairness.bending_ratio, point.fairness.bending_added}) {
    csv += ',';
    if (figure) append_number(csv, *figure);
  }
  csv += yes_or_no(point.fairness.is_smooth());
  csv += ',' + std::to_string(point.sweeps) + ',' + std::string(to_string(point.stop)) + ',';
  append_number(csv, point.seconds);
  csv += '\n';
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

std::vector<double> frontier_limits(double largest_strain, int points) {
  if (!(largest_strain > k_no_strain)) return {0.0};
  const double least = std::min(k_least_limit, 0.1 * largest_strain);
  std::vector<double> limits;
  for (int i = 0; i + 1 < points; ++i) {
    const double share = points > 2 ? static_cast<double>(i) / (points - 2) : 1.0;
    limits.push_back(std::min(1.0, largest_strain * math::pow(least / largest_strain, share)));
  }
  limits.push_back(0.0);
  return limits;
}

std::optional<FrontierReport> frontier(TriMesh mesh, std::string name,
                                       const FrontierOptions& options,
                                       const OnCompareProgress& on_progress) {
  check(options);
  const auto tell = [&] { return !on_progress || on_progress(FlattenStage::unfolding, "", 0.0); };
  if (!tell()) return std::nullopt;
  const auto before =
      unfold_patch(mesh, options.unit, [&](int /*step*/, double /*energy*/) { return tell(); },
                   {.threads = options.threads});
  if (!before) return std::nullopt;

  auto compared = compare(std::move(mesh), std::move(name), runs_of(options, before->strain.max),
                          {options.unit, options.threads, options.constraints}, on_progress);
  if (!compared) return std::nullopt;

  FrontierReport report;
  report.name = std::move(compared->name);
  report.unit = options.unit;
  report.before = before->strain;
  report.limit = options.limit;
  const std::size_t on_curve = compared->runs.size() - options.others.size();
  for (std::size_t i = 0; i < compared->runs.size(); ++i) {
    const ComparedMethod& run = compared->runs[i];
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
  return report;
}

std::string frontier_csv(const FrontierReport& report) {
  std::string csv =
      "method,max_strain,strain_rms,strain_p99,strain_max,deviation_rms,deviation_max,"
      "rms_over_diagonal,flattenable,bending_ratio,bending_added,smooth,sweeps,stop,seconds\n";
  for (const auto* points : {&report.curve, &report.others}) {
    for (const FrontierPoint& point : *points)
      append_point(csv, point);
  }
  return csv;
}

}  // namespace planish
