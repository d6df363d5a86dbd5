#include "report/page/compare_table.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

#include "core/figure_text.h"
#include "core/number_text.h"
#include "draw/text/markup_text.h"
#include "report/charts/convergence_chart.h"

namespace planish {

namespace {

using Figure = std::optional<double>;

enum class Best { none, smallest, largest };

/// A figure of the input and of every run.
struct Column {
  std::string_view name, unit;
  Best best;
  std::string (*write)(double);
  Figure (*of_input)(const CompareReport&);
  Figure (*of_run)(const ComparedMethod&);
};

std::string write_three(double value) {
  return significant_text(value, 3);
}

std::string write_two(double value) {
  return significant_text(value, 2);
}

std::string write_tick(double value) {
  return value != 0.0 ? "✓ yes" : "no";
}

std::string write_count(double value) {
  return count_text(static_cast<std::size_t>(value));
}

double degrees(double radians) {
  return 180.0 / std::numbers::pi * radians;
}

Figure strain_of(const std::optional<UnfoldReport>& unfold, double EdgeStrain::*figure) {
  return unfold ? Figure(unfold->strain.*figure) : std::nullopt;
}

Figure nothing(const CompareReport&) {
  return {};
}

template <double Flattenability::*Member>
Column patch_column(std::string_view name, std::string_view unit) {
  return {name,
          unit,
          Best::smallest,
          write_three,
          [](const CompareReport& r) -> Figure { return r.before.figures.*Member; },
          [](const ComparedMethod& m) -> Figure { return m.evolve->after.figures.*Member; }};
}

template <double EdgeStrain::*Member>
Column strain_column(std::string_view name) {
  return {name,
          "of edges",
          Best::smallest,
          percent_text,
          [](const CompareReport& r) { return strain_of(r.unfold_before, Member); },
          [](const ComparedMethod& m) { return strain_of(m.unfold, Member); }};
}

/// What the material feels first, then what is left to flatten, then what it cost.
std::vector<Column> columns() {
  Column angle = patch_column<&Flattenability::min_angle>("Smallest angle", "°");
  angle.best = Best::largest;
  angle.write = [](double value) { return significant_text(degrees(value), 3); };
  return {strain_column<&EdgeStrain::rms>("Strain, rms"),
          strain_column<&EdgeStrain::max>("Strain, worst"),
          patch_column<&Flattenability::sum_abs_defect>("Curvature left", "rad"),
          patch_column<&Flattenability::e_max>("e_max", "rad"),
          patch_column<&Flattenability::energy>("Energy", "rad²"),
          {"Deviation", "rms, of size", Best::smallest, percent_text, nothing,
           [](const ComparedMethod& m) -> Figure { return m.evolve->deviation.rms_over_diagonal; }},
          angle,
          {"Bending", "of the design's", Best::smallest, write_three, nothing,
           [](const ComparedMethod& m) -> Figure { return m.evolve->fairness.bending_ratio; }},
          {"Bending added", "of the design's", Best::smallest, write_three, nothing,
           [](const ComparedMethod& m) -> Figure { return m.evolve->fairness.bending_added; }},
          {"Smooth", "", Best::none, write_tick, nothing,
           [](const ComparedMethod& m) -> Figure { return m.evolve->fairness.is_smooth(); }},
          {"Sweeps", "", Best::none, write_count, nothing,
           [](const ComparedMethod& m) -> Figure {
             return static_cast<double>(m.evolve->result.history.size());
           }},
          {"Time", "s", Best::smallest, write_two, nothing,
           [](const ComparedMethod& m) -> Figure { return m.evolve->result.seconds; }}};
}

Figure best_of(const Column& column, const CompareReport& report) {
  Figure best;
  for (const ComparedMethod& method : report.runs) {
    if (!method.evolve || method.evolve->deviation.max == 0.0) continue;
    const Figure figure = column.of_run(method);
    if (!figure || std::isnan(*figure) || column.best == Best::none) continue;
    if (!best || (column.best == Best::smallest ? *figure < *best : *figure > *best)) best = figure;
  }
  return best;
}

std::string cell(const Column& column, Figure figure, bool is_best) {
  if (!figure) return "<td>–</td>";
  const std::string number =
      "<data value=\"" + number_text(*figure) + "\">" + column.write(*figure) + "</data>";
  if (!is_best) return "<td>" + number + "</td>";
  return "<td class=\"best\"><span title=\"best\">★</span> <b>" + number + "</b></td>";
}

std::string stop_word(StopReason stop) {
  const std::string word(to_string(stop));  // "sweep_limit" is "limit"
  return word.substr(word.find('_') + 1);
}

std::string head(const std::vector<Column>& all) {
  std::string html = "<thead><tr><th scope=\"col\">Method</th>";
  for (const Column& column : all) {
    html += "<th scope=\"col\">" + std::string(column.name) + "<small>" + std::string(column.unit) +
            "</small></th>";
  }
  return html + "<th scope=\"col\">Ended by</th></tr></thead>\n";
}

}  // namespace

std::string compare_table(const CompareReport& report) {
  const std::vector<Column> all = columns();
  std::string html = "<table class=\"compare\">\n" + head(all) +
                     "<tbody>\n<tr class=\"input\"><th scope=\"row\">input</th>";
  for (const Column& column : all)
    html += cell(column, column.of_input(report), false);
  html += "<td>–</td></tr>\n";
  for (std::size_t i = 0; i < report.runs.size(); ++i) {
    const ComparedMethod& method = report.runs[i];
    html += "<tr><th scope=\"row\">" + run_swatch(i) + escape_markup(name_of(method.run.method)) +
            "</th>";
    if (!method.evolve) {
      html += "<td class=\"failed\" colspan=\"" + std::to_string(all.size() + 1) + "\">" +
              escape_markup(verdict_text(report, method)) + "</td></tr>\n";
      continue;
    }
    const bool moved = method.evolve->deviation.max > 0.0;
    for (const Column& column : all) {
      const Figure figure = column.of_run(method), best = best_of(column, report);
      html += cell(column, figure, moved && best && figure == best);
    }
    html += "<td>" + stop_word(method.evolve->result.stop) + "</td></tr>\n";
  }
  return html + "</tbody>\n</table>\n";
}

std::string run_swatch(std::size_t run) {
  return "<svg class=\"swatch\" viewBox=\"0 0 36 8\" aria-hidden=\"true\"><polyline class=\"" +
         run_css_class(run) + "\" points=\"1,4 35,4\"/></svg>";
}

}  // namespace planish
