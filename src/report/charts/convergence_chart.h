#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <planish/evolve/evolver.h>
#include <planish/flatten/compare.h>
#include <planish/measure/flattenability.h>

namespace planish {

/// A figure that is known before the first sweep and after every one.
struct ChartFigure {
  std::string_view name, css_class;
  double Flattenability::*before;
  double SweepRecord::*after;
};
inline constexpr std::array k_chart_figures = {
    ChartFigure{"e_max", "line-e-max", &Flattenability::e_max, &SweepRecord::e_max},
    ChartFigure{"e_avg", "line-e-avg", &Flattenability::e_avg, &SweepRecord::e_avg},
    ChartFigure{"energy", "line-energy", &Flattenability::energy, &SweepRecord::energy}};

/// How e_max, e_avg and energy went, sweep by sweep, each as a share of what it was before, on a
/// logarithmic axis: inline SVG. A figure that was 0 before has no line, and a line ends where the
/// figure reaches 0. Empty where there is no line at all.
/// @param reference history of another method on the same patch, whose e_max is a grey line; may be
///   empty
std::string convergence_chart(const Flattenability& before, const std::vector<SweepRecord>& history,
                              const std::vector<SweepRecord>& reference = {});

enum class ChartAgainst { sweeps, seconds };

/// How one figure went with every method, likewise; both axes logarithmic.
std::string comparison_chart(const CompareReport& report, const ChartFigure& figure,
                             ChartAgainst against);

/// The style of the lines of one of the runs: colour and dashes.
std::string run_css_class(std::size_t run);

}  // namespace planish
