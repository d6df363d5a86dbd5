#include "report/page/figures_table.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "core/figure_text.h"
#include "core/number_text.h"

namespace planish {

namespace {

using Write = std::function<std::string(double)>;

// How large a figure should be.
enum class Aim { none, small, large, one };

struct Row {
  std::string name, explanation;
  Aim aim = Aim::small;
  Write write;
  // One number, or several as in 412 x 538; none: no such figure.
  std::vector<double> before, after;
  double nothing = 0.0;  // what is below this is rounding, and no better or worse than any other
};

std::string cell(const std::vector<double>& values, const Write& write) {
  std::string html = "<td>";
  for (const double& value : values) {
    if (&value != &values.front()) html += " × ";
    html += "<data value=\"" + number_text(value) + "\">" + write(value) + "</data>";
  }
  return html + (values.empty() ? "–</td>" : "</td>");
}

std::string change_text(double before, double after) {
  if (before == 0.0) return "from 0";
  const double ratio = after / before;
  if (ratio > 0.0 && ratio <= 0.1) return "÷ " + about_text(1.0 / ratio);
  if (ratio >= 3.0) return "× " + about_text(ratio);
  return signed_percent_text(ratio - 1.0);
}

// What lies between these shares of a figure is the same to anyone who reads it.
bool is_same(const Row& row, double before, double after) {
  if (row.aim == Aim::one) return std::abs(after - before) < 5e-5;
  return before == after || std::max(before, after) < row.nothing ||
         std::abs(after - before) <= 0.005 * std::abs(before);
}

std::string change_cell(const Row& row) {
  if (row.aim == Aim::none || row.before.empty()) return "<td>–</td>";
  const double before = row.before.front(), after = row.after.front();
  if (is_same(row, before, after)) {
    return "<td class=\"same\">same</td>";
  }
  const bool better = row.aim == Aim::small   ? after < before
                      : row.aim == Aim::large ? after > before
                                              : std::abs(after - 1.0) < std::abs(before - 1.0);
  const std::string word = better ? "better" : "worse";
  return "<td class=\"" + word + "\">" + change_text(before, after) + " <b>" + word + "</b></td>";
}

std::string write_number(double value) {
  return significant_text(value, 3);
}

Write with_unit(const std::string& unit) {
  return [unit](double value) { return significant_text(value, 3) + " " + unit; };
}

std::string write_yes(double value) {
  return value != 0.0 ? "yes" : "no";
}

std::vector<Row> defect_rows(const Flattenability& before, const Flattenability& after) {
  const Write radians = with_unit("rad");
  return {{"Largest angle defect",
           "e_max: the vertex furthest from flat",
           Aim::small,
           radians,
           {before.e_max},
           {after.e_max},
           1e-9},
          {"Mean angle defect",
           "e_avg, over all inner vertices",
           Aim::small,
           radians,
           {before.e_avg},
           {after.e_avg},
           1e-9},
          {"Energy",
           "sum of squared defects: what the sweeps lower; a finer mesh has less of it",
           Aim::small,
           write_number,
           {before.energy},
           {after.energy},
           1e-15},
          {"Curvature left",
           "sum of |defect|: the same at any fineness of the mesh",
           Aim::small,
           radians,
           {before.sum_abs_defect},
           {after.sum_abs_defect},
           1e-6}};
}

std::vector<Row> strain_rows(const EdgeStrain& before, const EdgeStrain& after) {
  return {{"Strain, rms",
           "how much the pattern's lengths differ from the patch's",
           Aim::small,
           percent_text,
           {before.rms},
           {after.rms},
           1e-6},
          {"Strain, 99 % of the area",
           "edges of 99 % of the area stay below this",
           Aim::small,
           percent_text,
           {before.p99},
           {after.p99},
           1e-6},
          {"Strain, worst edge",
           "the place that the material suffers most",
           Aim::small,
           percent_text,
           {before.max},
           {after.max},
           1e-6}};
}

std::vector<Row> mesh_rows(const Flattenability& before, const Flattenability& after) {
  constexpr double degrees = 180.0 / std::numbers::pi;
  const Write write = [](double value) { return significant_text(value, 3) + "°"; };
  return {{"Smallest angle",
           "of a triangle: needles near 0° spoil later work",
           Aim::large,
           write,
           {degrees * before.min_angle},
           {degrees * after.min_angle}}};
}

std::vector<double> listed(const std::optional<double>& figure) {
  return figure ? std::vector<double>{*figure} : std::vector<double>{};
}

/// How smooth the form is, beside the design where there is one to compare with.
std::vector<Row> fairness_rows(const EvolveReport& report) {
  const Fairness& fairness = report.fairness;
  const MeasuredPatch &before = report.before, &after = report.after;
  const Write turn = [](double value) { return significant_text(value, 3) + "°"; };
  const auto count = [](const SelfIntersections& found) {
    return std::vector<double>{static_cast<double>(found.pairs)};
  };
  return {{"Bending",
           "squared curvature times area, the same at any fineness of the mesh",
           Aim::none,
           write_number,
           {before.bending.bending},
           {after.bending.bending}},
          {"Bending over the design's",
           "noise of the design left out; smooth up to 1.3",
           Aim::none,
           write_number,
           {},
           listed(fairness.bending_ratio)},
          {"Bending added",
           "what the design did not have, over its bending; smooth up to 1",
           Aim::none,
           write_number,
           {},
           listed(fairness.bending_added)},
          {"Bending lost",
           "what went of the design's; form kept up to 0.5",
           Aim::none,
           write_number,
           {},
           listed(fairness.bending_lost)},
          {"Sharply bent",
           "share of the area, more than 99 % of the design is; smooth up to 4 %",
           Aim::none,
           percent_text,
           {},
           {fairness.sharp_share}},
          {"Mean curvature",
           "over the size of the patch",
           Aim::none,
           write_number,
           {before.bending.mean_curvature},
           {after.bending.mean_curvature}},
          {"Ruling defect",
           "0 where straight lines run through every place, 0.5 on a ball",
           Aim::none,
           write_number,
           {before.ruling_defect},
           {after.ruling_defect}},
          {"Turn of the surface",
           "of its normals, rms",
           Aim::none,
           turn,
           {},
           listed(fairness.normal_turn)},
          {"Turn along the border",
           "of its triangles, rms: what is sewn beside it must meet it",
           Aim::none,
           turn,
           {},
           listed(fairness.border_turn)},
          {"Crossings", "pairs of triangles that go through each other", Aim::small,
           [](double value) { return count_text(static_cast<std::size_t>(value)); },
           count(before.self_intersections), count(after.self_intersections)}};
}

std::vector<Row> deviation_rows(const Deviation& deviation, const std::string& unit) {
  const double per_unit = deviation.rms > 0.0 ? deviation.rms_over_diagonal / deviation.rms : 0.0;
  return {{"Deviation, rms",
           "how far vertices are from where they were",
           Aim::none,
           with_unit(unit),
           {},
           {deviation.rms}},
          {"Deviation, rms over size",
           "the same as a share of the patch's diagonal",
           Aim::none,
           percent_text,
           {},
           {deviation.rms_over_diagonal}},
          {"Deviation, largest",
           "the vertex that moved furthest",
           Aim::none,
           with_unit(unit),
           {},
           {deviation.max}},
          {"Deviation, largest over size",
           "the same as a share of the patch's diagonal",
           Aim::none,
           percent_text,
           {},
           {per_unit * deviation.max}}};
}

/// Of a border that moved.
std::vector<Row> border_rows(const std::optional<BoundaryChange>& border, const std::string& unit) {
  if (!border) return {};
  return {{"Border, length",
           "of all its edges; what is sewn to it must go along",
           Aim::none,
           with_unit(unit),
           {border->length_before},
           {border->length_after}},
          {"Border, largest move",
           "of its vertices, which were allowed to move",
           Aim::none,
           with_unit(unit),
           {},
           {border->max}}};
}

std::vector<Row> pattern_rows(const Pattern& before, const Pattern& after,
                              const std::string& unit) {
  const Write whole = [](double value) { return count_text(static_cast<std::size_t>(value)); };
  const auto ratio = [](double value) { return decimals_text(value, 4); };
  const auto number = [](std::size_t count) { return static_cast<double>(count); };
  return {{"Pattern size",
           "width × height, in " + unit,
           Aim::none,
           [](double value) { return significant_text(value, 4); },
           {before.width, before.height},
           {after.width, after.height}},
          {"Area ratio",
           "area of the pattern over area of the patch",
           Aim::one,
           ratio,
           {before.area_ratio},
           {after.area_ratio}},
          {"Flipped triangles",
           "of the pattern; must be none",
           Aim::small,
           whole,
           {number(before.flipped_triangles)},
           {number(after.flipped_triangles)}},
          {"Overlap",
           "the pattern covers itself: divide the patch",
           Aim::small,
           write_yes,
           {before.overlaps ? 1.0 : 0.0},
           {after.overlaps ? 1.0 : 0.0}}};
}

std::vector<Row> joined(std::vector<Row> rows, std::vector<Row> more) {
  std::move(more.begin(), more.end(), std::back_inserter(rows));
  return rows;
}

std::string section(const std::string& title, const std::vector<Row>& rows) {
  std::string html = "<tbody>\n<tr><th colspan=\"4\" scope=\"rowgroup\">" + title + "</th></tr>\n";
  for (const Row& row : rows) {
    html += "<tr><th scope=\"row\">" + row.name + "<small>" + row.explanation + "</small></th>" +
            cell(row.before, row.write) + cell(row.after, row.write) + change_cell(row) + "</tr>\n";
  }
  return html + "</tbody>\n";
}

}  // namespace

std::string figures_table(const FlattenReport& report) {
  const Flattenability& before = report.evolve.before.figures;
  const Flattenability& after = report.evolve.after.figures;
  const std::string unit(to_string(report.unfold.unit));
  return "<table>\n<thead><tr><th scope=\"col\">Figure</th><th scope=\"col\">Before</th>"
         "<th scope=\"col\">After</th><th scope=\"col\">Change</th></tr></thead>\n" +
         section("Pattern: what the material feels",
                 joined(strain_rows(report.as_designed.strain, report.unfold.strain),
                        pattern_rows(report.as_designed.pattern, report.unfold.pattern, unit))) +
         section("Patch: how far from flattenable", defect_rows(before, after)) +
         section("Form: what it cost",
                 joined(joined(deviation_rows(report.evolve.deviation, unit),
                               border_rows(report.evolve.border, unit)),
                        joined(fairness_rows(report.evolve), mesh_rows(before, after)))) +
         "</table>\n";
}

}  // namespace planish
