#include "report/page/compare_table.h"

#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <string_view>

#include "core/figure_text.h"
#include "core/number_text.h"
#include "draw/text/markup_text.h"
#include "report/charts/convergence_chart.h"
#include "report/json_parts.h"

namespace planish {

namespace {

enum class Best { none, smallest, largest };

/// A figure of the input and of every run.
struct Column {
  std::string_view name, unit;
  Best best;
  std::string (*write)(double);
  const char* path;  ///< in the JSON of a run
};

template <int Digits>
std::string write(double value) {
  return significant_text(value, Digits);
}

std::string write_tick(double value) {
  return value != 0.0 ? "✓ yes" : "no";
}

std::string write_count(double value) {
  return count_text(static_cast<std::size_t>(value));
}

std::string write_degrees(double radians) {
  return significant_text(180.0 / std::numbers::pi * radians, 3);
}

/// What the material feels first, then what is left to flatten, then what it cost.
constexpr Column k_columns[] = {
    {"Strain, rms", "of edges", Best::smallest, percent_text, "/unfold/strain/rms"},
    {"Strain, worst", "of edges", Best::smallest, percent_text, "/unfold/strain/max"},
    {"Curvature left", "rad", Best::smallest, write<3>, "/after/sum_abs_defect"},
    {"e_max", "rad", Best::smallest, write<3>, "/after/e_max"},
    {"Energy", "rad²", Best::smallest, write<3>, "/after/energy"},
    {"Deviation", "rms, of size", Best::smallest, percent_text, "/deviation/rms_over_diagonal"},
    {"Smallest angle", "°", Best::largest, write_degrees, "/after/min_angle"},
    {"Bending", "of the design's", Best::smallest, write<3>, "/bending_ratio"},
    {"Bending added", "of the design's", Best::smallest, write<3>, "/bending_added"},
    {"Smooth", "", Best::none, write_tick, "/smooth"},
    {"Sweeps", "", Best::none, write_count, "/sweeps"},
    {"Time", "s", Best::smallest, write<2>, "/seconds"}};

using Figure = std::optional<double>;

Figure figure_of(const Json& run, const Column& column) {
  const Json::json_pointer path(column.path);
  if (!run.contains(path) || run[path].is_null()) return {};
  const Json& figure = run[path];
  return figure.is_boolean() ? Figure(figure.get<bool>()) : Figure(figure.get<double>());
}

bool has_moved(const Json& run) {
  return run.contains("deviation") && run["deviation"]["max"] > 0.0;
}

Figure best_of(const Column& column, const Json& runs) {
  Figure best;
  for (const Json& run : runs) {
    const Figure figure = figure_of(run, column);
    if (!has_moved(run) || !figure || std::isnan(*figure) || column.best == Best::none) continue;
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

std::string head() {
  std::string html = "<thead><tr><th scope=\"col\">Method</th>";
  for (const Column& column : k_columns) {
    html += "<th scope=\"col\">" + std::string(column.name) + "<small>" + std::string(column.unit) +
            "</small></th>";
  }
  return html + "<th scope=\"col\">Ended by</th></tr></thead>\n";
}

}  // namespace

std::string compare_table(const CompareReport& report) {
  const Json all = report, &runs = all["runs"];
  const Json input = {{"after", all["input"]}, {"unfold", all["unfold_before"]}};
  std::string html = "<table class=\"compare\">\n" + head() +
                     "<tbody>\n<tr class=\"input\"><th scope=\"row\">input</th>";
  for (const Column& column : k_columns)
    html += cell(column, figure_of(input, column), false);
  html += "<td>–</td></tr>\n";
  for (std::size_t i = 0; i < report.runs.size(); ++i) {
    const ComparedMethod& method = report.runs[i];
    html += "<tr><th scope=\"row\">" + run_swatch(i) + escape_markup(name_of(method.run.method)) +
            "</th>";
    if (!method.evolve) {
      html += "<td class=\"failed\" colspan=\"" + std::to_string(std::size(k_columns) + 1) + "\">" +
              escape_markup(verdict_text(report, method)) + "</td></tr>\n";
      continue;
    }
    for (const Column& column : k_columns) {
      const Figure figure = figure_of(runs[i], column), best = best_of(column, runs);
      html += cell(column, figure, has_moved(runs[i]) && best && figure == best);
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
