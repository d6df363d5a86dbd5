#include "report/page/figures_table.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <vector>

#include "core/figure_text.h"
#include "core/number_text.h"

namespace planish {

namespace {

using Write = std::function<std::string(double)>;

/// What a row shows of a state: one number, or several as in 412 x 538; none: no such figure.
struct Numbers : std::vector<double> {
  using std::vector<double>::vector;
  Numbers(double value) : vector{value} {}
  Numbers(std::size_t value) : vector{static_cast<double>(value)} {}
  Numbers(const std::optional<double>& value) {
    if (value) push_back(*value);
  }
};

/// How large a figure should be. What is below `nothing` is rounding, and no better or worse than
/// any other.
struct Aim {
  enum { none, small, large, one } size = none;
  double nothing = 0.0;
};

std::string cell(const Numbers& figure, const Write& write) {
  std::string html = "<td>";
  for (const double& value : figure) {
    if (&value != &figure.front()) html += " × ";
    html += "<data value=\"" + number_text(value) + "\">" + write(value) + "</data>";
  }
  return html + (figure.empty() ? "–</td>" : "</td>");
}

std::string change_text(double before, double after) {
  if (before == 0.0) return "from 0";
  const double ratio = after / before;
  if (ratio > 0.0 && ratio <= 0.1) return "÷ " + about_text(1.0 / ratio);
  if (ratio >= 3.0) return "× " + about_text(ratio);
  return signed_percent_text(ratio - 1.0);
}

// What lies between these shares of a figure is the same to anyone who reads it.
bool is_same(Aim aim, double before, double after) {
  if (aim.size == Aim::one) return std::abs(after - before) < 5e-5;
  return before == after || std::max(before, after) < aim.nothing ||
         std::abs(after - before) <= 0.005 * std::abs(before);
}

std::string change_cell(Aim aim, const Numbers& all_before, const Numbers& all_after) {
  if (aim.size == Aim::none || all_before.empty()) return "<td>–</td>";
  const double before = all_before.front(), after = all_after.front();
  if (is_same(aim, before, after)) return "<td class=\"same\">same</td>";
  const bool better = aim.size == Aim::small   ? after < before
                      : aim.size == Aim::large ? after > before
                                               : std::abs(after - 1.0) < std::abs(before - 1.0);
  const std::string word = better ? "better" : "worse";
  return "<td class=\"" + word + "\">" + change_text(before, after) + " <b>" + word + "</b></td>";
}

std::string write_number(double value) {
  return significant_text(value, 3);
}

std::string write_whole(double value) {
  return count_text(static_cast<std::size_t>(value));
}

std::string write_yes(double value) {
  return value != 0.0 ? "yes" : "no";
}

Write with_unit(const std::string& unit) {
  return [unit](double value) { return significant_text(value, 3) + unit; };
}

/// The rows of a part of the table.
class Section {
 public:
  explicit Section(const std::string& title)
      : html_("<tbody>\n<tr><th colspan=\"4\" scope=\"rowgroup\">" + title + "</th></tr>\n") {}

  void row(const std::string& name, const std::string& explanation, const Write& write,
           const Numbers& before, const Numbers& after, Aim aim = {}) {
    html_ += "<tr><th scope=\"row\">" + name + "<small>" + explanation + "</small></th>" +
             cell(before, write) + cell(after, write) + change_cell(aim, before, after) + "</tr>\n";
  }
  std::string html() const { return html_ + "</tbody>\n"; }

 private:
  std::string html_;
};

std::string pattern_section(const UnfoldReport& as_designed, const UnfoldReport& unfold) {
  Section section("Pattern: what the material feels");
  constexpr Aim small = {Aim::small, 1e-6};
  const EdgeStrain &least = as_designed.strain, &strain = unfold.strain;
  section.row("Strain, rms", "how much the pattern's lengths differ from the patch's", percent_text,
              least.rms, strain.rms, small);
  section.row("Strain, 99 % of the area", "edges of 99 % of the area stay below this", percent_text,
              least.p99, strain.p99, small);
  section.row("Strain, worst edge", "the place that the material suffers most", percent_text,
              least.max, strain.max, small);
  const Pattern &before = as_designed.pattern, &after = unfold.pattern;
  const bool in_inches = unfold.unit == Unit::in;
  const double shown = in_inches ? 1.0 : millimetres_per(unfold.unit);
  section.row("Pattern size", std::string("width × height, in ") + (in_inches ? "in" : "mm"),
              [shown](double value) { return significant_text(shown * value, 4); },
              {before.width, before.height}, {after.width, after.height});
  section.row("Area ratio", "area of the pattern over area of the patch",
              [](double value) { return decimals_text(value, 4); }, before.area_ratio,
              after.area_ratio, {Aim::one});
  section.row("Flipped triangles", "of the pattern; must be none", write_whole,
              before.flipped_triangles, after.flipped_triangles, {Aim::small});
  section.row("Overlap", "the pattern covers itself: divide the patch", write_yes,
              before.overlaps ? 1.0 : 0.0, after.overlaps ? 1.0 : 0.0, {Aim::small});
  return section.html();
}

std::string patch_section(const Flattenability& before, const Flattenability& after) {
  Section section("Patch: how far from flattenable");
  const Write radians = with_unit(" rad");
  section.row("Largest angle defect", "e_max: the vertex furthest from flat", radians, before.e_max,
              after.e_max, {Aim::small, 1e-9});
  section.row("Mean angle defect", "e_avg, over all inner vertices", radians, before.e_avg,
              after.e_avg, {Aim::small, 1e-9});
  section.row("Energy",
              "sum of squared defects: what the sweeps lower; a finer mesh has less of it",
              write_number, before.energy, after.energy, {Aim::small, 1e-15});
  section.row("Curvature left", "sum of |defect|: the same at any fineness of the mesh", radians,
              before.sum_abs_defect, after.sum_abs_defect, {Aim::small, 1e-6});
  return section.html();
}

/// How far vertices went, those of a border that moved too.
void add_moves(Section& section, const EvolveReport& report, const Write& length) {
  const Deviation& deviation = report.deviation;
  const double per_unit = deviation.rms > 0.0 ? deviation.rms_over_diagonal / deviation.rms : 0.0;
  section.row("Deviation, rms", "how far vertices are from where they were", length, {},
              deviation.rms);
  section.row("Deviation, rms over size", "the same as a share of the patch's diagonal",
              percent_text, {}, deviation.rms_over_diagonal);
  section.row("Deviation, largest", "the vertex that moved furthest", length, {}, deviation.max);
  section.row("Deviation, largest over size", "the same as a share of the patch's diagonal",
              percent_text, {}, per_unit * deviation.max);
  if (const auto& border = report.border) {
    section.row("Border, length", "of all its edges; what is sewn to it must go along", length,
                border->length_before, border->length_after);
    section.row("Border, largest move", "of its vertices, which were allowed to move", length, {},
                border->max);
  }
}

/// How smooth the form is, beside the design where there is one to compare with.
void add_fairness(Section& section, const EvolveReport& report) {
  const Fairness& fairness = report.fairness;
  const MeasuredPatch &before = report.before, &after = report.after;
  const Write turn = with_unit("°");
  section.row("Bending", "squared curvature times area, the same at any fineness of the mesh",
              write_number, before.bending.bending, after.bending.bending);
  section.row("Bending over the design's", "noise of the design left out; smooth up to 1.3",
              write_number, {}, fairness.bending_ratio);
  section.row("Bending added", "what the design did not have, over its bending; smooth up to 1",
              write_number, {}, fairness.bending_added);
  section.row("Bending lost", "what went of the design's; form kept up to 0.5", write_number, {},
              fairness.bending_lost);
  section.row("Sharply bent",
              "share of the area, more than 99 % of the design is; smooth up to 4 %", percent_text,
              {}, fairness.sharp_share);
  section.row("Mean curvature", "over the size of the patch", write_number,
              before.bending.mean_curvature, after.bending.mean_curvature);
  section.row("Ruling defect", "0 where straight lines run through every place, 0.5 on a ball",
              write_number, before.ruling_defect, after.ruling_defect);
  section.row("Turn of the surface", "of its normals, rms", turn, {}, fairness.normal_turn);
  section.row("Turn along the border", "of its triangles, rms: what is sewn beside it must meet it",
              turn, {}, fairness.border_turn);
  section.row("Crossings", "pairs of triangles that go through each other", write_whole,
              before.self_intersections.pairs, after.self_intersections.pairs, {Aim::small});
  constexpr double degrees = 180.0 / std::numbers::pi;
  section.row("Smallest angle", "of a triangle: needles near 0° spoil later work", turn,
              degrees * before.figures.min_angle, degrees * after.figures.min_angle, {Aim::large});
}

}  // namespace

std::string figures_table(const FlattenReport& report) {
  const EvolveReport& evolve = report.evolve;
  Section form("Form: what it cost");
  add_moves(form, evolve,
            [unit = report.unfold.unit](double value) { return length_text(value, unit, 3); });
  add_fairness(form, evolve);
  return "<table>\n<thead><tr><th scope=\"col\">Figure</th><th scope=\"col\">Before</th>"
         "<th scope=\"col\">After</th><th scope=\"col\">Change</th></tr></thead>\n" +
         pattern_section(report.design_pattern, report.unfold) +
         patch_section(evolve.before.figures, evolve.after.figures) + form.html() + "</table>\n";
}

}  // namespace planish
