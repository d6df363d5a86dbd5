#include <algorithm>
#include <array>
#include <span>
#include <string_view>

#include <planish/core/version.h>
#include <planish/report/html_report.h>
#include <planish/report/pattern_sheet.h>
#include <planish/report/strain_check.h>

#include "core/number_text.h"
#include "draw/markup_text.h"
#include "report/convergence_chart.h"
#include "report/figure_text.h"
#include "report/figures_table.h"
#include "report/html_parts.h"
#include "report/legend.h"
#include "report/patch_picture.h"
#include "report/pattern_picture.h"
#include "report/verdict.h"

namespace planish {

namespace {

constexpr int k_picture_width = 880;  // pixels: sharp at half of it

std::string unit_name(const FlattenReport& report) {
  return std::string(to_string(report.unfold.unit));
}

std::string tile(std::string_view name, const std::string& figure, const std::string& note) {
  return "<div><dt>" + std::string(name) + "</dt><dd>" + figure + "<small>" + note +
         "</small></dd></div>\n";
}

std::string tiles(const FlattenReport& report) {
  const EdgeStrain& before = report.unfold_before.strain;
  const EdgeStrain& after = report.unfold.strain;
  const Deviation& deviation = report.evolve.deviation;
  const Pattern& pattern = report.unfold.pattern;
  const std::string unit = "\u00A0" + unit_name(report);
  return "<dl class=\"tiles\">\n" +
         tile("Strain of the pattern", percent_text(after.rms),
              "rms; " + percent_text(before.rms) + " before") +
         tile("Strain at worst", percent_text(after.max), percent_text(before.max) + " before") +
         tile("Furthest move", significant_text(deviation.max, 2) + unit,
              significant_text(deviation.rms, 2) + unit + " rms") +
         tile("Pattern",
              significant_text(pattern.width, 3) + " × " + significant_text(pattern.height, 3) +
                  unit,
              "area " + decimals_text(pattern.area_ratio, 3) + " of the patch's") +
         "</dl>\n";
}

std::string figures_caption(std::string_view when, const Flattenability& figures) {
  return "<b>" + std::string(when) + "</b> largest " + significant_text(figures.e_max, 2) +
         "\u00A0rad, in sum " + significant_text(figures.sum_abs_defect, 2) + "\u00A0rad";
}

std::string pictures(const FlattenReport& report, ColorMap colors) {
  const std::array<std::span<const Vec3>, 1> after = {report.processed.positions};
  const PatchPictures pictures = patch_pictures(report.input, after, colors, k_picture_width);
  return "<section class=\"keep\">\n<h2>The patch</h2>\n<p>Coloured by angle defect: what the "
         "angles around a vertex lack to a full turn. Both pictures have the same view and scale. "
         "Values beyond the ends of the scale have the colour of its ends.</p>\n"
         "<div class=\"pair\">\n" +
         html_picture(pictures.before, "The patch as it came, coloured by angle defect",
                      figures_caption("Before:", report.evolve.before.figures)) +
         html_picture(pictures.after.front(), "The patch after evolving, coloured by angle defect",
                      figures_caption("After:", report.evolve.after.figures)) +
         "</div>\n" + legend(fields_of(colors), defect_labels(colors, pictures.limit)) +
         "</section>\n";
}

std::string pattern_section(const FlattenReport& report) {
  const Drawing sheet = pattern_sheet(report.processed, report.unfold, report.name);
  const PatternPicture picture =
      pattern_picture(sheet, "The pattern, coloured by strain, with its cut line");
  const std::string limit =
      fixed_text(100.0 * strain_map_limit(report.unfold.strain), 3) + "\u00A0%";
  return "<section class=\"keep\">\n<h2>The pattern</h2>\n<p>Coloured by strain: how much longer "
         "or shorter the pattern is than the patch.</p>\n<figure>" +
         picture.svg + "<figcaption>The bar is " + number_text(picture.bar) +
         "\u00A0mm long.</figcaption></figure>\n" +
         legend(strain_map_fields(),
                {"shorter <b>−" + limit + "</b>", "<b>0</b>", "longer <b>+" + limit + "</b>"}) +
         "</section>\n";
}

// What was done, in words, under the chart.
std::string run_list(const FlattenReport& report) {
  const Topology& topology = report.evolve.before.inspection.topology;
  const EvolveResult& result = report.evolve.result;
  return "<dl class=\"run\">\n" +
         html_entry("Patch", count_text(topology.vertices) + " vertices, " +
                                 count_text(topology.inner_vertices) + " of them inner; " +
                                 count_text(topology.triangles) + " triangles") +
         html_entry("Method", std::string(name_of(report.evolve.method))) +
         html_entry("Options", options_text(report.evolve.method)) +
         html_entry("Run", effort_text(result)) + html_entry("Ended as", stop_text(result.stop)) +
         "</dl>\n";
}

constexpr std::string_view k_level_words =
    " While sweeps work on coarser levels, the patch itself stays as it is, and so do its figures.";

bool has_levels(const FlattenReport& report) {
  const auto& history = report.evolve.result.history;
  return std::any_of(history.begin(), history.end(),
                     [](const SweepRecord& record) { return record.level.has_value(); });
}

std::string convergence_section(const FlattenReport& report) {
  const std::string chart =
      convergence_chart(report.evolve.before.figures, report.evolve.result.history);
  std::string words =
      chart.empty() ? "Nothing to show: no sweep was made, or there was nothing to lower."
                    : "Largest and mean angle defect and energy after each sweep, as a share of "
                      "what they were before; logarithmic.";
  if (has_levels(report)) words += k_level_words;
  return "<section class=\"keep\">\n<h2>The sweeps</h2>\n<p>" + words + "</p>\n" + chart +
         run_list(report) + "</section>\n";
}

// Those of the patch as it came, and after them what evolving brought.
std::string problems_section(const FlattenReport& report) {
  const auto& before = report.evolve.before.inspection.problems;
  std::string items;
  const auto add = [&](const Problem& problem, std::string_view when) {
    items += "<li><code>" + escape_markup(to_string(problem.code)) + "</code> " +
             escape_markup(problem.message) + " (" + count_text(problem.count) + " in all" +
             std::string(when) + ")</li>\n";
  };
  for (const Problem& problem : before)
    add(problem, "");
  for (const Problem& problem : report.evolve.after.inspection.problems) {
    const bool is_old = std::any_of(before.begin(), before.end(), [&](const Problem& other) {
      return other.code == problem.code;
    });
    if (!is_old) add(problem, ", since evolving");
  }
  if (items.empty()) return {};
  return "<section>\n<h2>Problems of the mesh</h2>\n<ul class=\"problems\">\n" + items +
         "</ul>\n</section>\n";
}

std::string footer(const FlattenReport& report) {
  return std::string("<footer>Made by planish ") + k_version +
         ". Model unit: " + unit_name(report) + ".</footer>\n";
}

}  // namespace

std::string html_report(const FlattenReport& report, ColorMap colors) {
  const std::string border = border_text(report);
  const auto check = check_strain(report);
  const std::string title = report.name.empty() ? "Patch" : escape_markup(report.name);
  return html_head(title) +
         "<body>\n<main>\n<header>\n<p class=\"brand\">Planish report</p>\n<h1>" + title +
         "</h1>\n<p class=\"verdict\">" +
         escape_markup(verdict_text(report) + (check ? " " + check_text(*check) : "") +
                       (border.empty() ? "" : " " + border)) +
         "</p>\n</header>\n" + tiles(report) + pictures(report, colors) + "<div class=\"wide\">\n" +
         pattern_section(report) + convergence_section(report) +
         "</div>\n<section>\n<h2>All figures</h2>\n<div class=\"scroll\">\n" +
         figures_table(report) + "</div>\n</section>\n" + problems_section(report) +
         footer(report) + "</main>\n</body>\n</html>\n";
}

}  // namespace planish
