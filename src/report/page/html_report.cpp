#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <planish/core/version.h>
#include <planish/measure/flattenability.h>
#include <planish/report/html_report.h>
#include <planish/sheet/pattern_sheet.h>

#include "core/figure_text.h"
#include "draw/text/markup_text.h"
#include "flatten/limit_checks.h"
#include "flatten/strain_limit_text.h"
#include "flatten/twin_report.h"
#include "flatten/verdict.h"
#include "pattern/polygon/loop_box.h"
#include "report/charts/convergence_chart.h"
#include "report/charts/defect_histogram.h"
#include "report/page/candidate_tiles.h"
#include "report/page/figures_table.h"
#include "report/page/html_parts.h"
#include "report/page/html_viewer.h"
#include "report/page/page_assets.h"
#include "sheet/limit_map.h"

namespace planish {

namespace {

/// A tick or a cross with words, so that no one need tell colours apart.
std::string mark(bool good, const std::string& words) {
  return std::string("<span class=\"") + (good ? "met\">✓ " : "missed\">✗ ") + words + "</span>";
}

std::string tile(std::string_view name, const std::string& figure, const std::string& note,
                 const std::string& marks) {
  return "<div><dt>" + std::string(name) + "</dt><dd>" + figure + "<small>" + note + "</small>" +
         marks + "</dd></div>\n";
}

std::string limit_mark(const FlattenReport& report, Criterion what) {
  for (const LimitCheck& check : limit_checks(report)) {
    if (check.what == what)
      return mark(check.met, escape_markup(limit_text(check, report.unfold.unit)));
  }
  return {};
}

std::string material_mark(const FlattenPage& page) {
  if (page.material.empty()) return {};
  return mark(page.fits, (page.fits ? "fits " : "does not fit ") + escape_markup(page.material));
}

std::string tiles(const FlattenReport& report, const PatternGeometry& drawn,
                  const FlattenPage& page) {
  const EdgeStrain& before = report.design_pattern.strain;
  const EdgeStrain& after = report.unfold.strain;
  const bool is_compressed = after.max_compression > after.max_stretch;
  const Deviation& deviation = report.evolve.deviation;
  const Pattern& pattern = report.unfold.pattern;
  const Unit unit = report.unfold.unit;
  std::string area =
      "area " + decimals_text(pattern.area_ratio, 3) + " of the patch's; outer side up";
  if (report.unfold.turned)
    area += ". The piece was turned over: it was inside out against a neighbour";
  if (drawn.options.allowance) {
    const Vec2 cut_size = 1.0 / millimetres_per(unit) * loop_box(drawn.cut).size();
    area = size_text(cut_size.x, cut_size.y, unit) + " with the allowance; " + area;
  }
  return "<dl class=\"tiles\">\n" +
         tile(is_compressed ? "Largest compression" : "Largest stretch", percent_text(after.max),
              largest_strain_text(before) + " before", limit_mark(report, Criterion::strain)) +
         tile("Usual stretch", percent_text(after.rms), percent_text(before.rms) + " before (rms)",
              limit_mark(report, Criterion::rms_strain)) +
         tile("Furthest move", length_text(deviation.max, unit),
              length_text(deviation.rms, unit) + " is usual (rms)",
              limit_mark(report, Criterion::deviation)) +
         tile("Size of the pattern", size_text(pattern.width, pattern.height, unit), area,
              material_mark(page)) +
         "</dl>\n";
}

/// What is neither right nor wrong.
std::string neutral_mark(const std::string& words) {
  return "<span class=\"neutral\">• " + words + "</span>";
}

/// Limits of strain that were asked for, and whether it lies flat.
std::vector<std::string> flatness_checks(const FlattenReport& report) {
  std::vector<std::string> items;
  for (const LimitCheck& check : report.unfold.limits) {
    items.push_back(mark(check.met, (check.met ? "within " : "not within ") +
                                        escape_markup(strain_limit_name(check, report))));
  }
  const std::string stretched = "does not lie flat without stretch";
  if (flatness_of(report) == Flatness::flat)
    items.push_back(mark(true, "lies flat without stretch"));
  else if (flatness_of(report) == Flatness::not_known)
    items.push_back(neutral_mark("cannot be judged"));
  else if (is_too_small_to_measure(report.unfold.strain))
    items.push_back(flatness_of(report) == Flatness::limit_missed
                        ? neutral_mark("a stretch too small to measure, but for some places")
                        : mark(true, "flat but for a stretch too small to measure"));
  else if (report.outcome().misses(Criterion::stretched))
    items.push_back(mark(false, stretched));
  else
    items.push_back(neutral_mark(items.empty() ? "needs a sheet that takes " +
                                                     percent_text(report.unfold.strain.p99)
                                               : stretched));
  return items;
}

/// Whether a designer would take the form.
std::vector<std::string> form_checks(const EvolveReport& evolve) {
  const Fairness& fairness = evolve.fairness;
  const std::string loss = form_loss_text(fairness);
  std::vector<std::string> items;
  if (fairness.unchanged) {
    items.push_back(mark(true, "form as designed"));
  } else {
    items.push_back(mark(fairness.is_smooth(), std::string(smoothness_word(fairness))));
    if (!loss.empty())
      items.push_back(mark(false, "form not kept: " + loss));
    else if (fairness.form_change)
      items.push_back(mark(true, "form kept"));
  }
  const std::size_t before = evolve.before.self_intersections.pairs,
                    after = evolve.after.self_intersections.pairs;
  if (after > before)
    items.push_back(mark(false, "the form goes through itself"));
  else if (after > 0)
    items.push_back(neutral_mark("the design goes through itself"));
  return items;
}

/// All that is either right or wrong, what was asked for first.
std::string checks(const FlattenReport& report) {
  const Pattern& pattern = report.unfold.pattern;
  std::vector<std::string> items = flatness_checks(report);
  for (const Caution& caution : report.cautions)
    items.push_back(neutral_mark(std::string(words_of(caution))));
  for (const std::string& item : form_checks(report.evolve))
    items.push_back(item);
  const bool flipped = pattern.flipped_triangles > 0;
  items.push_back(
      mark(!pattern.overlaps, pattern.overlaps ? "overlaps itself" : "does not overlap itself"));
  items.push_back(mark(
      !flipped, flipped ? "parts of the pattern are flipped over" : "no part is flipped over"));
  if (!unit_question(report.unfold).empty())
    items.push_back(neutral_mark("check the model's unit"));
  constexpr std::array<std::pair<Criterion, std::string_view>, 4> names = {
      {{Criterion::deviation, "moves "},
       {Criterion::angle, "angles of triangles "},
       {Criterion::e_max, "worst place "},
       {Criterion::bending, "bending "}}};
  for (const LimitCheck& check : limit_checks(report)) {
    const auto name = std::find_if(names.begin(), names.end(),
                                   [&](const auto& some) { return some.first == check.what; });
    if (name == names.end()) continue;
    items.push_back(mark(check.met, std::string(name->second) +
                                        escape_markup(limit_text(check, report.unfold.unit))));
  }
  std::string html = "<ul class=\"checks\">\n";
  for (const std::string& item : items)
    html += "<li>" + item + "</li>\n";
  return html + "</ul>\n";
}

// What was done, in words.
std::string run_section(const FlattenReport& report, const FlattenPage& page) {
  const Topology& topology = report.evolve.before.inspection.topology;
  const EvolveResult& result = report.evolve.result;
  std::string html =
      "<section class=\"keep\">\n<h2>The run</h2>\n<dl class=\"run\">\n" +
      html_entry("Patch", count_text(topology.vertices) + " vertices, " +
                              count_text(topology.inner_vertices) + " of them inner; " +
                              count_text(topology.triangles) + " triangles") +
      html_entry("Method", std::string(report.evolve.method_name())) +
      (report.evolve.method ? html_entry("Options", options_text(*report.evolve.method)) : "") +
      html_entry("Run", effort_text(result)) + html_entry("Ended as", stop_text(result.stop));
  if (report.twin_of)
    html +=
        html_entry("Twin", twin_text(*report.twin_of) + ", whose pattern and surface were taken");
  if (!page.material.empty())
    html += html_entry(page.fits ? "Laid on" : "To be laid on",
                       page.material + "; " + page.material_use);
  if (!page.command.empty())
    html += "<dt>Command</dt><dd><code>" + escape_markup(page.command) + "</code></dd>\n";
  return html + html_entry("Program", "planish " + std::string(k_version)) + "</dl>\n</section>\n";
}

constexpr std::string_view k_level_words =
    " While sweeps work on coarser levels, the patch itself stays as it is, and so do its figures.";

constexpr std::string_view k_worst_place_words =
    " It ends lower here, which makes no better pattern: stretch is what all places bring "
    "together, and no single one of them.";

bool has_levels(const FlattenReport& report) {
  const auto& history = report.evolve.result.history;
  return std::any_of(history.begin(), history.end(),
                     [](const SweepRecord& record) { return record.level.has_value(); });
}

std::string convergence_section(const FlattenReport& report, const FlattenPage& page) {
  const std::string chart =
      convergence_chart(report.evolve.before.figures, report.evolve.result.history, page.reference);
  std::string words =
      chart.empty() ? "Nothing to show: no sweep was made, or there was nothing to lower."
                    : "What is left of the worst place and of the whole after each sweep, as a "
                      "share of what it was. Equal steps on the scale are equal factors.";
  if (has_levels(report)) words += k_level_words;
  if (!chart.empty() && !page.reference.empty()) {
    words += " Grey: the worst place by the method of 2010, for comparison.";
    if (page.reference.back().e_max < report.evolve.after.figures.e_max)
      words += k_worst_place_words;
  }
  return "<section class=\"keep\">\n<h2>How it went, sweep by sweep</h2>\n<p>" + words + "</p>\n" +
         chart + "<details class=\"terms\"><summary>The terms of the paper</summary>\n<dl>\n" +
         html_entry("e_max", "the largest |angle defect| of an inner vertex (Eq. 18)") +
         html_entry("e_avg", "the mean |angle defect| of the inner vertices (Eq. 19)") +
         html_entry("energy", "the sum of the squared angle defects (Eq. 4)") +
         html_entry("2010 method", "controllable Laplacian evolution, a sweep of the paper each") +
         "</dl></details>\n</section>\n";
}

std::vector<double> inner_defects(const Patch& patch) {
  const auto defects = angle_defects(patch);
  std::vector<double> inner;
  inner.reserve(patch.inner_vertices().size());
  for (const Index v : patch.inner_vertices())
    inner.push_back(defects[v]);
  return inner;
}

std::string histogram_section(const FlattenReport& report) {
  const std::string chart =
      defect_histogram(inner_defects(report.input), inner_defects(report.processed));
  return "<section class=\"keep\">\n<h2>How flat all places are</h2>\n<p>" +
         (chart.empty() ? std::string("Nothing to show: the patch has no inner vertex.")
                        : std::string("How many places are how far from flat: the further left, "
                                      "the flatter. What is left of the line is flat for any "
                                      "material.")) +
         "</p>\n" + chart +
         "<details class=\"terms\"><summary>The terms of the paper</summary>\n<dl>\n" +
         html_entry("angle that is missing or too much",
                    "|angle defect| |d|, d = 2π − θ (Eq. 3), of every inner vertex") +
         html_entry("flat enough", "|d| below " + significant_text(k_flattenable_e_max, 1) +
                                       " rad: the bound of flattenable for e_max") +
         "</dl></details>\n</section>\n";
}

// Those of the input patch, and after them what evolving changed.
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

/// All that is for those who know the method, in the terms of the paper.
std::string computed_section(const FlattenReport& report, const FlattenPage& page) {
  const std::string limits = strain_limits_text(report.unfold.limits);
  return "<details class=\"computed\">\n<summary>How it was computed</summary>\n<p>" +
         escape_markup(computed_text(report) + (limits.empty() ? "" : " " + limits)) +
         "</p>\n<div class=\"wide\">\n" + convergence_section(report, page) +
         histogram_section(report) + "</div>\n" + run_section(report, page) + "</details>\n";
}

/// Where the pattern is in true size.
std::string files_line(const FlattenPage& page) {
  if (page.files.empty()) return {};
  std::string links;
  for (const PageFile& file : page.files) {
    links += (links.empty() ? "" : "; ") + std::string("<a href=\"") + escape_markup(file.path) +
             "\">" + escape_markup(file.path) + "</a> " + escape_markup(file.purpose);
  }
  return "<p class=\"files\">The pattern in true size: " + links + ".</p>\n";
}

}  // namespace

std::string html_report(const FlattenReport& report, const FlattenPage& page) {
  const PatternGeometry pattern = pattern_geometry(report);
  return html_report(report, pattern,
                     pattern_sheet(report.processed.mesh(), report.unfold, pattern), page);
}

std::string html_report(const FlattenReport& report, const PatternGeometry& pattern,
                        const Drawing& sheet, const FlattenPage& page) {
  const std::string border = border_text(report);
  const PatchViewer viewer = html_viewer(report, pattern, sheet, page.colors);
  const std::string verdict = verdict_text(report) + (border.empty() ? "" : " " + border);
  const bool has_limit = limit_of_edges(report.unfold.limits).has_value();
  return html_page(
      {"report", report.name, verdict, checks(report),
       has_limit ? limit_style() : std::string_view(), std::string(to_string(report.unfold.unit)),
       viewer.data, app_links(page.project)},
      files_line(page) + candidate_tiles(report) + viewer.html + tiles(report, pattern, page) +
          "<section>\n<h2>All figures</h2>\n<div class=\"scroll\">\n" + figures_table(report) +
          "</div>\n</section>\n" + problems_section(report) + computed_section(report, page));
}

}  // namespace planish
