#include "text/compare_text.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "shell/text.h"
#include "text/angles.h"

namespace planish::cli {

namespace {

constexpr std::size_t k_widest_name = 21;

/// Columns behind the name; with the widest name 80 in all.
constexpr std::array<std::size_t, 8> k_widths = {8, 8, 8, 6, 8, 7, 7, 7};
constexpr std::array<std::string_view, 8> k_heads = {"e_max",   "strain", "deviat.", "angle",
                                                     "bending", "added",  "smooth",  "time"};
constexpr std::array<std::string_view, 8> k_units = {"rad",   "rms %", "rms %", "deg",
                                                     "ratio", "ratio", "",      "s"};

using MethodCells = std::array<std::string, 8>;

std::string ratio_cell(const std::optional<double>& ratio) {
  return ratio ? shorter_number(*ratio) : "-";
}

std::string row(const std::string& name, const MethodCells& cells, std::size_t name_width) {
  std::string line = left(name.substr(0, name_width), name_width);
  for (std::size_t i = 0; i < cells.size(); ++i)
    line += right(cells[i], k_widths[i]);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

std::string strain_cell(const std::optional<UnfoldReport>& unfold) {
  return unfold ? short_number(100.0 * unfold->strain.rms) : "-";
}

MethodCells input_cells(const CompareReport& report) {
  const Flattenability& figures = report.before.figures;
  return {short_number(figures.e_max),
          strain_cell(report.design_least_stretch),
          "-",
          shorter_number(k_degrees * figures.min_angle),
          "-",
          "-",
          "-",
          "-"};
}

MethodCells run_cells(const ComparedMethod& method) {
  const EvolveReport& evolve = *method.evolve;
  const Flattenability& figures = evolve.after.figures;
  return {short_number(figures.e_max),
          strain_cell(method.unfold),
          short_number(100.0 * evolve.deviation.rms_over_diagonal),
          shorter_number(k_degrees * figures.min_angle),
          ratio_cell(evolve.fairness.bending_ratio),
          ratio_cell(evolve.fairness.bending_added),
          evolve.fairness.is_smooth() ? "yes" : "no",
          shorter_number(evolve.result.seconds)};
}

std::size_t name_width(const CompareReport& report) {
  std::size_t width = 12;
  for (const ComparedMethod& method : report.runs)
    width = std::max(width, name_of(method.run.method).size());
  return std::min(width, k_widest_name);
}

std::string table(const CompareReport& report) {
  const std::size_t width = name_width(report);
  MethodCells heads, units, failed;
  std::copy(k_heads.begin(), k_heads.end(), heads.begin());
  std::copy(k_units.begin(), k_units.end(), units.begin());
  failed.fill("-");
  failed.back() = "failed";
  std::string text =
      row("", heads, width) + row("", units, width) + row("input", input_cells(report), width);
  for (const ComparedMethod& method : report.runs) {
    text += row(std::string(name_of(method.run.method)), method.evolve ? run_cells(method) : failed,
                width);
  }
  return text;
}

}  // namespace

std::string compare_text(const CompareReport& report) {
  const std::size_t indent = name_width(report) + 2;
  std::string text = table(report) + "\n";
  for (const ComparedMethod& method : report.runs) {
    const std::string name(name_of(method.run.method));
    text += left(name.substr(0, indent - 2), indent) +
            wrapped(verdict_text(report, method), indent) + "\n";
  }
  const auto best = best_run(report);
  text += "\nBest: " +
          wrapped(best ? std::string(name_of(report.runs[*best].run.method))
                       : "none; no method improved this patch without a price like needles",
                  6) +
          "\n";
  if (!report.design_least_stretch) {
    text += wrapped("No patterns, so no strain: " + report.why_no_patterns, 0) + "\n";
  }
  return text +
         wrapped(
             "Read strain first: it is what the material feels. Lower energy or e_max "
             "alone does not make a better pattern.",
             0) +
         "\n";
}

}  // namespace planish::cli
