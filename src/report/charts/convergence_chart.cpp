#include "report/charts/convergence_chart.h"

#include <cmath>

#include <planish/evolve/method.h>

#include "core/figure_text.h"
#include "core/math.h"
#include "core/number_text.h"
#include "draw/text/markup_text.h"
#include "report/charts/log_chart.h"

namespace planish {

namespace {

/// What a figure was, sweep by sweep, from before the first; it ends where the figure reaches 0.
/// @param x_of a record -> where it stands
/// @param unit what figures are divided by
template <class XOf>
std::vector<Vec2> points_of(double before, const std::vector<SweepRecord>& history,
                            double SweepRecord::*figure, double unit, const XOf& x_of) {
  if (!(before > 0.0) || !std::isfinite(before)) return {};
  std::vector<Vec2> points = {{0.0, before / unit}};
  for (const SweepRecord& record : history) {
    const double y = record.*figure / unit;
    if (!(y > 0.0) || !std::isfinite(y)) break;
    points.push_back({x_of(record), y});
  }
  return points;
}

double sweep_of(const SweepRecord& record) {
  return static_cast<double>(record.sweep);
}

// Short enough for the margin.
std::string share_text(double share) {
  if (share >= 0.01) return significant_text(share, 2);
  if (share >= 1e-4) return "1/" + about_text(1.0 / share);
  return power_of_ten_text(static_cast<int>(std::lround(math::log10(share))));
}

bool has_length(const std::vector<ChartLine>& lines) {
  for (const ChartLine& line : lines) {
    if (line.points.back().x > 0.0) return true;
  }
  return false;
}

double before_of(const ChartFigure& figure, const Flattenability& before) {
  return before.*figure.before;
}

}  // namespace

std::string convergence_chart(const Flattenability& before, const std::vector<SweepRecord>& history,
                              const std::vector<SweepRecord>& reference) {
  std::vector<ChartLine> lines;
  std::string label =
      "After " + std::to_string(history.size()) + " sweeps, as a share of the start:";
  for (const ChartFigure& figure : k_chart_figures) {
    const double start = before_of(figure, before);
    ChartLine line{std::string(figure.name), std::string(figure.css_class),
                   points_of(start, history, figure.after, start, sweep_of)};
    if (line.points.empty()) continue;
    line.name += " " + share_text(line.points.back().y);
    label += (lines.empty() ? " " : ", ") + line.name;
    lines.push_back(std::move(line));
  }
  if (!has_length(lines)) return {};
  ChartLine other{"2010 e_max", "line-reference",
                  points_of(before.e_max, reference, &SweepRecord::e_max, before.e_max, sweep_of)};
  if (!reference.empty() && !other.points.empty()) {
    other.name += " " + share_text(other.points.back().y);
    label += "; " + other.name;
    lines.insert(lines.begin(), std::move(other));
  }
  return log_chart(lines, ChartScale::whole, "sweep", label + ".");
}

std::string comparison_chart(const CompareReport& report, const ChartFigure& figure,
                             ChartAgainst against) {
  const bool by_sweep = against == ChartAgainst::sweeps;
  std::vector<ChartLine> lines;
  std::string label = std::string(figure.name) +
                      (by_sweep ? " against sweeps; at the end:" : " against seconds; at the end:");
  for (std::size_t i = 0; i < report.runs.size(); ++i) {
    const ComparedMethod& method = report.runs[i];
    if (!method.evolve) continue;
    const auto x_of = [&](const SweepRecord& r) { return by_sweep ? sweep_of(r) : r.seconds; };
    ChartLine line{escape_markup(name_of(method.run.method)), run_css_class(i),
                   points_of(before_of(figure, report.before.figures),
                             method.evolve->result.history, figure.after, 1.0, x_of)};
    if (line.points.empty()) continue;
    label +=
        (lines.empty() ? " " : ", ") + line.name + " " + significant_text(line.points.back().y, 2);
    lines.push_back(std::move(line));
  }
  if (!has_length(lines)) return {};
  return log_chart(lines, ChartScale::logarithmic, by_sweep ? "sweeps" : "seconds", label + ".");
}

std::string run_css_class(std::size_t run) {
  constexpr std::size_t styles = 9;  // of web/report/page.css; more lines take them anew
  return "line-" + std::to_string(run % styles);
}

}  // namespace planish
