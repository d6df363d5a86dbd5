#include "text/summary.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include <planish/core/ways_on.h>

#include "flatten/strain_limit_text.h"
#include "flatten/verdict.h"
#include "platform/memory.h"
#include "platform/path.h"
#include "shell/text.h"
#include "shell/values.h"
#include "text/angles.h"
#include "text/candidates_text.h"
#include "text/large_patch.h"
#include "text/lengths.h"
#include "text/ways_text.h"

namespace planish::cli {

namespace {

/// Without the blanks that keep number and unit together in pages: lines are wrapped at blanks.
std::string with_plain_blanks(std::string text) {
  constexpr std::string_view blank = "\u00A0";
  for (std::size_t at = 0; (at = text.find(blank, at)) != std::string::npos;)
    text.replace(at, blank.size(), " ");
  return text;
}

/// What the mesh cannot show, as a paragraph behind an empty line.
std::string cautions_lines(std::span<const Caution> cautions, Unit unit) {
  if (cautions.empty()) return {};
  return "\n" + wrapped(with_plain_blanks(cautions_text(cautions, unit)), 0) + "\n";
}

/// Name, unit and figures of one line. All are better when smaller, but the smallest angle.
struct Row {
  std::string name, unit;
  double before = 0.0, after = 0.0;
  std::string meaning = {};
  bool larger_is_better = false;
};

std::vector<Row> figure_rows(const Flattenability& before, const Flattenability& after) {
  return {{"e_max", "rad", before.e_max, after.e_max, "largest angle defect"},
          {"e_avg", "rad", before.e_avg, after.e_avg, "mean size of the angle defects"},
          {"energy", "rad^2", before.energy, after.energy, "sum of the squared defects"},
          {"sum_abs_defect", "rad", before.sum_abs_defect, after.sum_abs_defect,
           "the same at every mesh density"},
          {"smallest angle", "deg", k_degrees * before.min_angle, k_degrees * after.min_angle, "",
           true}};
}

std::string change_text(double before, double after) {
  if (before == after) return "same";
  if (before == 0.0) return "";
  const double change = 100.0 * (after / before - 1.0);
  if (!std::isfinite(change) || std::abs(change) >= 99999.5) return "";
  if (std::abs(change) < 0.05) return "0.0 %";
  return (change < 0.0 ? "" : "+") + fixed(change, 1) + " %";
}

/// A change that anyone would notice, for the worse.
bool is_worse(const Row& row) {
  constexpr double rounding = 1e-9, little = 0.005;
  const double more = row.larger_is_better ? row.before - row.after : row.after - row.before;
  return more > std::max(rounding, little * std::abs(row.before));
}

std::string comparison(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows) {
    text += "  " + left(row.name, 24) + left(row.unit, 7) + right(digits(row.before), 11) +
            right(digits(row.after), 13) + right(change_text(row.before, row.after), 13) +
            (is_worse(row) ? "  worse\n" : "\n");
  }
  return text;
}

std::string comparison_head() {
  return left("", 33) + right("before", 11) + right("after", 13) + right("change", 13) + "\n";
}

/// A figure with its unit and what it is; in one column with the others of the text.
std::string line(const std::string& name, const std::string& figure, const std::string& unit = {},
                 const std::string& meaning = {}) {
  const std::string rest = meaning.empty() ? unit : left(unit, 7) + meaning;
  return "  " + left(name, 24) + right(figure, 11) + (rest.empty() ? "" : " " + rest) + "\n";
}

std::string line(const std::string& name, std::size_t count, const std::string& meaning = {}) {
  return line(name, std::to_string(count), meaning);
}

std::string sizes_text(const std::string& path, const Topology& t) {
  return path + "\n\n" + line("vertices", t.vertices) + line("inner vertices", t.inner_vertices) +
         line("triangles", t.triangles) + line("components", t.components) +
         line("border loops", t.border_loops) +
         line("Euler characteristic", std::to_string(t.euler_characteristic));
}

/// How large the patch is; an area in square centimetres, or in square inches.
std::string extent_text(const PatchSize& size, Unit unit) {
  const ShownLengths lengths(unit);
  const double millimetres = millimetres_per(unit);
  const bool in_inches = unit == Unit::in;
  const double area = in_inches ? size.area : 0.01 * millimetres * millimetres * size.area;
  return line("extent in x, y, z", lengths.number(size.extent.x) + " x " +
                                       lengths.number(size.extent.y) + " x " +
                                       lengths.text(size.extent.z)) +
         line("area", digits(area), in_inches ? "in^2" : "cm^2") +
         line("border length", lengths.number(size.border_length), lengths.unit());
}

std::string problems_text(const Inspection& inspection) {
  if (inspection.problems.empty()) return {};
  std::string text = "\nProblems:\n";
  for (const Problem& problem : inspection.problems) {
    text += "  " + std::string(to_string(problem.code)) + " (" + std::to_string(problem.count) +
            ")\n    " + wrapped(problem.message + ". " + std::string(way_on(problem.code)), 4) +
            "\n";
  }
  return text;
}

std::string fitness_line(const std::string& what, const Inspection& inspection, Purpose purpose) {
  const auto problem = blocking_problem(inspection, purpose);
  return problem ? line(what, "", "", "no: " + std::string(to_string(problem->code)))
                 : line(what, "yes");
}

std::string obstruction_advice(const Obstruction& obstruction) {
  return std::string(obstruction.has_flat_border()
                         ? "the border is flat and convex, so that only a plane piece fits it"
                         : "the border is too short for the patch") +
         ": at least " + percent(obstruction.excess_share) + " of the area (" +
         digits(obstruction.area_excess, 3) + " of " + digits(obstruction.area, 3) +
         " square units) must go before it can lie flat with this border. Evolving can only pull "
         "the surface in; a dart or a cut keeps its form.";
}

/// What the border of a disk demands of a flat piece.
std::string obstruction_text(const std::optional<Obstruction>& obstruction) {
  if (!obstruction) return {};
  const Obstruction& o = *obstruction;
  std::string text =
      "\nFor its border:\n" + line("area", digits(o.area), "", "of the patch, square units") +
      line("largest flat area", digits(o.area_limit), "", "the most with this border") +
      line("must go at least", digits(100.0 * o.excess_share, 3), "%", "of the area") +
      line("sum of defects", digits(o.total_defect), "rad", "what the border's turning lacks") +
      line("border turns", digits(o.border_turning), "rad",
           digits(k_flat_turning) + " when flat, " + digits(o.turning_most) + " at most");
  if (o.is_notable()) text += "\n" + wrapped("Advice: " + obstruction_advice(o), 0) + "\n";
  return text;
}

std::string count_of(const SelfIntersections& found) {
  if (found.complete) return std::to_string(found.pairs);
  return found.pairs > 0 ? "at least " + std::to_string(found.pairs) : "not known";
}

/// What measuring tells of the form without a design to compare with.
std::string form_text(const MeasuredPatch& patch) {
  return line("bending", digits(patch.bending.bending), "", "squared curvature over the area") +
         line("mean curvature", digits(patch.bending.mean_curvature), "", "over the size, in all") +
         line("ruling defect", digits(patch.ruling_defect), "",
              "0 on a bent sheet, 0.5 on a ball") +
         line("self-intersections", count_of(patch.self_intersections), "",
              "pairs of triangles that cross");
}

std::string answer(bool yes, const std::string& words) {
  return words + ": " + (yes ? "yes" : "no");
}

/// How the form came out of it, in words.
std::string form_lines(const EvolveReport& report) {
  const Fairness& fairness = report.fairness;
  const std::string indent(14, ' ');
  std::string text = "  form        " + answer(fairness.is_smooth(), "smooth");
  if (!fairness.is_smooth()) text += " (" + std::string(smoothness_word(fairness)) + ")";
  if (fairness.form_change) text += ", " + answer(fairness.keeps_form(), "form kept");
  text += "\n";
  if (!fairness.keeps_form())
    text += indent + wrapped(form_loss_text(fairness), indent.size()) + "\n";
  if (fairness.bending_ratio && !fairness.unchanged) {
    text += indent + "bending " + digits(*fairness.bending_ratio, 3) + " times that of the design";
    if (fairness.bending_added) {
      text += ": added " + digits(*fairness.bending_added, 2) + ", lost " +
              digits(*fairness.bending_lost, 2);
    }
    text += "\n";
    const Auto* options = report.auto_options();
    if (options != nullptr && options->max_bending > 0.0 &&
        *fairness.bending_ratio > options->max_bending)
      text += indent + "more than the " + digits(options->max_bending, 3) + " of --max-bending\n";
  }
  if (fairness.sharpest_fold) {
    text += indent + "sharpest new fold " + digits(fairness.sharpest_fold->degrees, 2) +
            " deg at " + place_text(fairness.sharpest_fold->at) + "\n";
  }
  const SelfIntersections& found = report.after.self_intersections;
  if (found.pairs > 0) {
    text += indent + "goes through itself: " + count_of(found) +
            " pairs of triangles cross, the first at " + place_text(found.first->at) + "\n";
  }
  return text;
}

std::string deviation_lines(const Deviation& deviation, const ShownLengths& lengths) {
  return "  deviation   rms " + lengths.number(deviation.rms) + ", largest " +
         lengths.text(deviation.max) + "\n              rms is " +
         percent(deviation.rms_over_diagonal) + " of the bounding box's diagonal\n";
}

std::string border_line(const std::optional<BoundaryChange>& border, const ShownLengths& lengths) {
  if (!border) return {};
  const double change = border->length_after / border->length_before - 1.0;
  return "  border      moved by at most " + lengths.text(border->max) + ", its length " +
         (change < 0.0 ? "-" : "+") + percent(std::abs(change)) + "\n";
}

std::string remeshing_line(const EvolveReport& report) {
  if (!report.remeshed_from) return {};
  return "remeshed from " + std::to_string(report.remeshed_from->vertices) + " to " +
         std::to_string(report.before.inspection.topology.vertices) +
         " vertices; the border keeps all of its own\n";
}

std::string smoothing_line(const EvolveReport& report, const ShownLengths& lengths) {
  const auto& smoothed = report.smoothed_first;
  if (!smoothed) return {};
  return "design smoothed first: waves shorter than " + lengths.text(smoothed->length) +
         " taken out, moved " + lengths.text(smoothed->moved.rms) + " rms, at most " +
         lengths.text(smoothed->moved.max) + "\n";
}

std::string run_line(const EvolveReport& report, const ShownLengths& lengths) {
  return remeshing_line(report) + smoothing_line(report, lengths) +
         std::string(report.method_name()) + ": " + counted(report.result.history.size(), "sweep") +
         " in " + fixed(report.result.seconds, 2) + " s on " +
         counted(report.result.threads, "thread") + ", ended as\n  " +
         std::string(stop_text(report.result.stop)) + "\n";
}

/// What evolving did to the form.
std::string change_lines(const EvolveReport& report, const ShownLengths& lengths) {
  if (report.result.history.empty() && report.fairness.unchanged)
    return "  form        as designed\n" + remeshing_line(report);
  return form_lines(report) + deviation_lines(report.deviation, lengths) +
         border_line(report.border, lengths) + "\n" + run_line(report, lengths);
}

std::string pattern_lines(const UnfoldReport& report) {
  const Pattern& pattern = report.pattern;
  const ShownLengths lengths(report.unit);
  return "  pattern     " + lengths.number(pattern.width) + " x " + lengths.text(pattern.height) +
         ", " + percent(pattern.area_ratio) + " of the patch's area\n" + "              " +
         (pattern.flipped_triangles == 0 ? "no flipped triangle"
                                         : counted(pattern.flipped_triangles, "flipped triangle")) +
         (pattern.overlaps ? ", overlaps itself" : ", no overlap") + "; outer side up\n" +
         (report.turned
              ? "              turned over: the piece was inside out against a neighbour\n"
              : "");
}

/// What keeping the border's lengths costs.
std::string matching_lines(const UnfoldReport& report) {
  if (!report.unmatched_strain) return {};
  return "  seams       border edges keep their lengths to " + digits(report.border_strain, 2) +
         "; without that\n              least stretch would be rms " +
         percent(report.unmatched_strain->rms) + ", largest " +
         percent(report.unmatched_strain->max) + "\n";
}

/// What keeping a limit or spreading costs.
std::string unlimited_lines(const UnfoldReport& report) {
  constexpr double same = 0.02;
  const EdgeStrain& strain = report.strain;
  if (!report.unlimited_strain || (strain.rms < (1.0 + same) * report.unlimited_strain->rms &&
                                   strain.max > (1.0 - same) * report.unlimited_strain->max))
    return {};
  const bool is_for_limit =
      std::any_of(report.limits.begin(), report.limits.end(), [&](const LimitCheck& check) {
        return figure_of(*report.unlimited_strain, check.what) > check.limit;
      });
  const std::string why = is_for_limit ? "evened out to keep the limit" : "spread";
  return "              " + why + "; with least stretch it would be\n              rms " +
         percent(report.unlimited_strain->rms) + ", largest " +
         percent(report.unlimited_strain->max) + "\n";
}

std::string as_designed_lines(const StrainAsDesigned& strain) {
  const EdgeStrain& least = strain.least_stretch;
  std::string text = "\n  strain      rms " + percent(least.rms) + ", 99 % of the area within " +
                     percent(least.p99) + ", largest " + percent(least.max) + "\n";
  if (strain.smallest_limit) {
    text +=
        "              in the pattern of least stretch; evened out, it could be cut\n"
        "              from a sheet that takes " +
        percent(*strain.smallest_limit) + " at every edge\n";
  }
  const std::string limits = strain_limits_text(strain.limits);
  return text + (limits.empty() ? "" : "\n" + wrapped(limits, 0) + "\n");
}

/// What else could be asked for, and at what price.
std::string choices_text(const FlattenReport& report) {
  const std::string ways = ways_text(report);
  return ways.empty() && report.evolve.method ? candidates_text(report) : ways;
}

/// What the verdict does not say of the limits: more than that the only one is kept.
std::string limits_to_tell(const std::vector<LimitCheck>& limits) {
  const bool is_said = limits.size() == 1 && limits.front().met;
  return limits.empty() || is_said ? "" : wrapped(strain_limits_text(limits), 0) + "\n\n";
}

}  // namespace

std::string place_text(Vec3 at) {
  return "(" + digits(at.x, 3) + ", " + digits(at.y, 3) + ", " + digits(at.z, 3) + ")";
}

std::string size_text(const TriMesh& mesh) {
  return std::to_string(mesh.positions.size()) + " vertices, " +
         std::to_string(mesh.triangles.size()) + " triangles";
}

std::string measure_text(const std::string& path, const MeasuredPatch& patch,
                         const std::optional<StrainAsDesigned>& strain,
                         std::span<const Caution> cautions, Unit unit) {
  const bool is_judged = unjudged_by(cautions, patch.flattenable) == nullptr;
  std::string text =
      sizes_text(path, patch.inspection.topology) + extent_text(patch.size, unit) + "\n";
  for (const Row& row : figure_rows(patch.figures, patch.figures))
    text += line(row.name, digits(row.before), row.unit, row.meaning);
  text += form_text(patch) + "\n" +
          line("flattenable", !is_judged          ? "not known"
                              : patch.flattenable ? "yes"
                                                  : "no") +
          fitness_line("can be evolved", patch.inspection, Purpose::evolve) +
          fitness_line("can be laid flat", patch.inspection, Purpose::unfold);
  if (strain) text += as_designed_lines(*strain);
  return text + obstruction_text(patch.obstruction) + cautions_lines(cautions, unit) +
         problems_text(patch.inspection);
}

std::string refused_text(const std::string& path, const Inspection& inspection) {
  return sizes_text(path, inspection.topology) + problems_text(inspection);
}

std::string evolve_text(const EvolveReport& report) {
  const ShownLengths lengths = ShownLengths::in_model_units();
  return run_line(report, lengths) + "\n" + comparison_head() +
         comparison(figure_rows(report.before.figures, report.after.figures)) + "\n" +
         deviation_lines(report.deviation, lengths) + border_line(report.border, lengths) +
         form_lines(report);
}

std::string unfold_text(const UnfoldReport& report, std::span<const Caution> cautions) {
  const std::string limits = strain_limits_text(report.limits);
  return pattern_lines(report) + "  strain      rms " + percent(report.strain.rms) +
         ", 99 % of the area within " + percent(report.strain.p99) + ", largest " +
         percent(report.strain.max) + "\n" + unlimited_lines(report) + matching_lines(report) +
         (limits.empty() ? "" : "\n" + wrapped(limits, 0) + "\n") +
         cautions_lines(cautions, report.unit);
}

std::string flatten_text(const FlattenReport& report) {
  const EvolveReport& evolve = report.evolve;
  const ShownLengths lengths(report.unfold.unit);
  return "\n" + wrapped(with_plain_blanks(verdict_text(report)), 0) + "\n\n" +
         limits_to_tell(report.unfold.limits) + choices_text(report) + "\n" +
         pattern_lines(report.unfold) + unlimited_lines(report.unfold) +
         matching_lines(report.unfold) + change_lines(evolve, lengths);
}

std::string directions_text(const DirectionCounts& counts) {
  return "\nInner vertices:\n" +
         line("flat", counts.flat,
              "angle defect at most " + digits(flat_defect(counts.inner), 2) + " rad") +
         line("dome or cup", counts.dome_or_cup, "angle defect above 0") +
         line("saddle", counts.saddle, "angle defect below 0") +
         line("can be lowered", counts.can_lower, "the Laplacian vector lowers ring energy") +
         line("stuck", counts.stuck, "it does not, and the vertex is not flat");
}

CommandResult with_target_checked(CommandResult outcome, const Arguments& arguments,
                                  const EvolveReport& report) {
  if (!arguments.has("--require-target") || report.outcome().target_met()) return outcome;
  outcome.exit_code = k_exit_target_missed;
  outcome.complaint = "target not met: e_max is " + digits(report.after.figures.e_max) + " after " +
                      counted(report.result.history.size(), "sweep") + " (" +
                      std::string(to_string(report.result.stop)) + "), the target is " +
                      shortest(report.stopping.target_e_max);
  return outcome;
}

void note_obstruction(Session& session, const Patch& patch) {
  const auto obstruction = find_obstruction(patch);
  if (obstruction && obstruction->is_notable()) session.note(obstruction_advice(*obstruction));
}

void note_cautions(Session& session, const std::string& path, std::span<const Caution> cautions,
                   Unit unit) {
  if (!cautions.empty())
    session.note(path + ": " + with_plain_blanks(cautions_text(cautions, unit)));
}

void note_memory(Session& session, const Method& method, std::size_t vertices) {
  if (memory_text(method, vertices, 0).empty()) return;
  session.note(memory_text(method, vertices, available_memory()));
}

void warn_of_method(Session& session, const Method& method, const Failure& failure) {
  session.warn(std::string(name_of(method)) + ": " + failure.message);
}

}  // namespace planish::cli
