#include "report/page/candidate_tiles.h"

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/figure_text.h"
#include "core/math.h"
#include "draw/text/markup_text.h"
#include "flatten/verdict.h"
#include "report/page/html_parts.h"
#include "report/pictures/patch_view.h"
#include "report/pictures/piece_outline.h"

namespace planish {

namespace {

/// A candidate with its surface and its pattern.
struct Shown {
  Candidate candidate;
  const Patch& surface;
  std::vector<Vec2> pattern;
};

/// Turned so that it lies as another pattern of the same vertices does, by least squares.
std::vector<Vec2> turned_like(std::span<const Vec2> other, const std::vector<Vec2>& pattern) {
  Vec2 middle, other_middle;
  const double share = 1.0 / static_cast<double>(pattern.size());
  for (std::size_t v = 0; v < pattern.size(); ++v) {
    middle = middle + share * pattern[v];
    other_middle = other_middle + share * other[v];
  }
  double along = 0.0, across = 0.0;
  for (std::size_t v = 0; v < pattern.size(); ++v) {
    const Vec2 p = pattern[v] - middle, q = other[v] - other_middle;
    along += p.x * q.x + p.y * q.y;
    across += p.x * q.y - p.y * q.x;
  }
  const double length = math::hypot(along, across);
  if (!(length > 0.0)) return pattern;
  const double cos = along / length, sin = across / length;
  std::vector<Vec2> turned;
  turned.reserve(pattern.size());
  for (const Vec2 p : pattern)
    turned.push_back({cos * p.x - sin * p.y, sin * p.x + cos * p.y});
  return turned;
}

std::vector<Shown> shown_candidates(const FlattenReport& report) {
  const std::vector<Candidate> candidates = report.candidates();
  const std::vector<Vec2>& design = report.design_pattern.pattern.positions;
  std::vector<Shown> shown = {{candidates.front(), report.input, design}};
  if (candidates.size() > 1) {
    shown.push_back({candidates.back(), report.processed,
                     turned_like(design, report.unfold.pattern.positions)});
  }
  return shown;
}

std::string stretch_words(const EdgeStrain& strain) {
  constexpr double not_measurable = 1e-6;
  if (strain.max < not_measurable) return "No stretch.";
  return "Stretch " + largest_strain_text(strain) + " at most, " + percent_text(strain.rms) +
         " as a rule.";
}

std::string move_words(const Candidate& candidate, Unit unit) {
  if (candidate.deviation.max == 0.0) return " Nothing moved.";
  return " Moved " + length_text(candidate.deviation.max, unit) + " at most, " +
         length_text(candidate.deviation.rms, unit) + " as a rule.";
}

std::string form_words(const Fairness& form) {
  if (form.unchanged) return {};
  const std::string text = " The form is " + std::string(smoothness_word(form));
  const std::string loss = form_loss_text(form);
  return text + (loss.empty() ? "." : form.is_smooth() ? ", but not kept." : ", and not kept.");
}

std::string name_of(const Candidate& candidate) {
  return candidate.is_design() ? "The design as it is" : "Changed";
}

std::string tile_of(const Shown& shown, const PatchView& view, const OutlineWindow& window,
                    bool is_result, Unit unit) {
  const Candidate& candidate = shown.candidate;
  const std::string limits =
      candidate.limits_kept ? "" : " It does not keep the limit that was asked for.";
  return std::string("<li") + (is_result ? " class=\"chosen\"" : "") + "><div class=\"views\">" +
         html_tile_picture(view.shaded(shown.surface.positions()),
                           name_of(candidate) + ": the surface, shaded") +
         piece_outline(shown.surface, shown.pattern, window,
                       name_of(candidate) + ": outline of the pattern") +
         "</div><h3>" + name_of(candidate) + "<small>" +
         (is_result ? "the result, pattern.*" : "as-designed.*") + "</small></h3><p>" +
         escape_markup(stretch_words(candidate.strain) + move_words(candidate, unit) +
                       form_words(candidate.fairness) + limits) +
         "</p></li>\n";
}

/// The limit, as people say it.
std::string name_of(const Way& way) {
  if (!way.material.empty())
    return way.material + (way.has_one_limit() ? " (" + percent_text(way.limit()) + ")" : "");
  if (way.limits.rms > 0.0) return percent_text(way.limits.rms) + " as a rule";
  return way.limits.p99 > 0.0 ? percent_text(way.limit()) + " on 99 % of the area"
                              : percent_text(way.limits.max) + " at most";
}

/// What becomes of the form.
std::string end_of(const Way& way) {
  if (!way.reached) return "not reached";
  if (way.fairness.unchanged) return way.estimated ? "about as designed" : "as designed";
  return way.keeps_form() ? "kept" : "not kept";
}

std::string row_of(const Way& way, Unit unit) {
  const std::string about = way.estimated ? "~ " : "";
  const auto cell = [](const std::string& text) { return "<td>" + escape_markup(text) + "</td>"; };
  const double fold = way.sharpest_fold();
  return "<tr><th scope=\"row\">" + escape_markup(name_of(way)) + "</th>" +
         cell(about + length_text(way.deviation.rms, unit)) +
         cell(about + length_text(way.deviation.max, unit)) +
         cell(fold > 0.0 ? about + significant_text(fold, 2) + "°" : "none") + cell(end_of(way)) +
         "</tr>\n";
}

/// What taking less stretch would do to the form.
std::string ways_table(const FlattenReport& report) {
  if (report.ways.empty()) return {};
  std::string html =
      "<h3>Less stretch costs form</h3>\n<div class=\"scroll\"><table class=\"ways\">\n"
      "<thead><tr><th scope=\"col\">Stretch to keep</th><th scope=\"col\">Usual move</th>"
      "<th scope=\"col\">Furthest move</th><th scope=\"col\">Sharpest new fold</th>"
      "<th scope=\"col\">Form</th></tr></thead>\n<tbody>\n";
  for (const Way& way : report.ways)
    html += row_of(way, report.unfold.unit);
  return html +
         "</tbody></table></div>\n<p>~ is an estimate, made on a coarse mesh. "
         "<code>--material</code> and <code>--max-rms-strain</code> ask for one of them.</p>\n";
}

}  // namespace

std::string candidate_tiles(const FlattenReport& report) {
  const std::vector<Shown> shown = shown_candidates(report);
  const std::array<std::span<const Vec3>, 1> others = {report.processed.positions()};
  const PatchView view(report.input.mesh(), others, k_tile_width);
  std::vector<std::vector<Vec2>> patterns;
  patterns.reserve(shown.size());
  for (const Shown& some : shown)
    patterns.push_back(some.pattern);
  const OutlineWindow window(patterns);
  std::string html =
      "<section class=\"candidates\">\n<h2>What there is to choose from</h2>\n<ol "
      "class=\"pieces\">\n";
  for (const Shown& some : shown)
    html += tile_of(some, view, window, &some == &shown.back(), report.unfold.unit);
  return html + "</ol>\n" + ways_table(report) +
         "<p>Less or more stretch: <code>--pick 1</code> is the design, 2 to 5 leave a "
         "usual stretch of 2, 1, 0.5 and 0.1 %, 6 is flat. <code>planish frontier</code> computes "
         "them all.</p>\n"
         "</section>\n";
}

}  // namespace planish
