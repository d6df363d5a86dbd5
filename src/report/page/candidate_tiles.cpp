#include "report/page/candidate_tiles.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/figure_text.h"
#include "core/math.h"
#include "core/number_text.h"
#include "draw/base64.h"
#include "draw/text/markup_text.h"
#include "report/pictures/patch_view.h"

namespace planish {

namespace {

constexpr int k_picture_width = 420;  // pixels: twice as wide as it is shown
constexpr Color k_surface = {196, 200, 204};

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
  const std::vector<Vec2>& design = report.as_designed.pattern.positions;
  std::vector<Shown> shown = {{candidates.front(), report.input, design}};
  if (candidates.size() > 1) {
    shown.push_back({candidates.back(), report.processed,
                     turned_like(design, report.unfold.pattern.positions)});
  }
  return shown;
}

/// The name of a candidate, without terms of measuring.
std::string plain_name(const Candidate& candidate) {
  constexpr std::string_view term = " rms";
  std::string name = candidate_name(candidate);
  const std::size_t at = name.find(term);
  if (at != std::string::npos) name.replace(at, term.size(), " usual stretch");
  return name;
}

std::string picture_of(const PatchView& view, const Shown& shown) {
  const std::vector<Color> colors(shown.surface.vertex_count(), k_surface);
  const Image image = view.picture(shown.surface.positions(), colors);
  return "<img width=\"" + std::to_string(image.width / 2) + "\" height=\"" +
         std::to_string(image.height / 2) +
         "\" alt=\"the surface, shaded: " + escape_markup(plain_name(shown.candidate)) +
         "\" src=\"data:image/png;base64," + base64(format_png(image)) + "\">";
}

struct Box {
  Vec2 low, high;
};

Box box_of(std::span<const Vec2> positions) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Box box = {{infinity, infinity}, {-infinity, -infinity}};
  for (const Vec2 p : positions) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

/// The largest width and height of the patterns, so that all can be drawn at one scale.
Vec2 size_of_all(const std::vector<Shown>& shown) {
  Vec2 size;
  for (const Shown& some : shown) {
    const Box box = box_of(some.pattern);
    size = {std::max(size.x, box.high.x - box.low.x), std::max(size.y, box.high.y - box.low.y)};
  }
  return size;
}

/// The border of the pattern in units of a hundredth of the larger side, y down.
std::string outline_of(const Shown& shown, Vec2 size) {
  constexpr double k_units = 100.0, k_margin = 2.0;
  const double larger = std::max(size.x, size.y), scale = larger > 0.0 ? k_units / larger : 1.0;
  const Box box = box_of(shown.pattern);
  const Vec2 middle = 0.5 * (box.low + box.high);
  const Vec2 room = {scale * size.x + 2.0 * k_margin, scale * size.y + 2.0 * k_margin};
  std::string path;
  for (const std::vector<Index>& loop : shown.surface.border_loops()) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Vec2 p = scale * (shown.pattern[loop[k]] - middle);
      path += std::string(k == 0 ? "M" : " ") + fixed_text(0.5 * room.x + p.x, 1) + " " +
              fixed_text(0.5 * room.y - p.y, 1);
    }
    path += "z";
  }
  return "<svg role=\"img\" aria-label=\"outline of the pattern\" viewBox=\"0 0 " +
         fixed_text(room.x, 1) + " " + fixed_text(room.y, 1) + "\"><path d=\"" + path +
         "\"/></svg>";
}

std::string stretch_words(const EdgeStrain& strain) {
  constexpr double not_measurable = 1e-6;
  if (strain.max < not_measurable) return "No stretch.";
  return "Stretch " + percent_text(strain.max) + " at most, " + percent_text(strain.rms) +
         " as a rule.";
}

std::string move_words(const Candidate& candidate, Unit unit) {
  if (candidate.deviation.max == 0.0) return " Nothing moved.";
  return " Moved " + length_text(candidate.deviation.max, unit) + " at most, " +
         length_text(candidate.deviation.rms, unit) + " as a rule.";
}

std::string form_words(const Fairness& form) {
  if (form.unchanged) return {};
  std::string text = form.is_smooth() ? " Smooth" : " Crumpled";
  if (!form.is_smooth() && form.sharpest_fold)
    text += ": a new fold of " + significant_text(form.sharpest_fold->degrees, 2) + "°";
  if (form.is_smooth() && !form.keeps_form()) text += ", but the form is lost";
  return text + ".";
}

/// What it is, and which files have its pattern.
std::string heading_of(const Candidate& candidate, bool is_result) {
  const std::string files = is_result ? "the result, pattern.*" : "as-designed.*";
  if (candidate.is_design()) return "The design as it is<small>" + files + "</small>";
  return "Changed<small>" + escape_markup(plain_name(candidate)) + "; " + files + "</small>";
}

std::string tile_of(const Shown& shown, const PatchView& view, Vec2 size, bool is_result,
                    Unit unit) {
  const Candidate& candidate = shown.candidate;
  const std::string limits =
      candidate.limits_kept ? "" : " It does not keep the limit that was asked for.";
  return std::string("<li") + (is_result ? " class=\"chosen\"" : "") + "><div class=\"views\">" +
         picture_of(view, shown) + outline_of(shown, size) + "</div><h3>" +
         heading_of(candidate, is_result) + "</h3><p>" +
         escape_markup(stretch_words(candidate.strain) + move_words(candidate, unit) +
                       form_words(candidate.fairness) + limits) +
         "</p></li>\n";
}

}  // namespace

std::string candidate_tiles(const FlattenReport& report) {
  const std::vector<Shown> shown = shown_candidates(report);
  const std::array<std::span<const Vec3>, 1> others = {report.processed.positions()};
  const PatchView view(report.input.mesh(), others, k_picture_width);
  const Vec2 size = size_of_all(shown);
  std::string html =
      "<section class=\"candidates\">\n<h2>What there is to choose from</h2>\n<ol>\n";
  for (const Shown& some : shown)
    html += tile_of(some, view, size, &some == &shown.back(), report.unfold.unit);
  return html +
         "</ol>\n<p>Less or more stretch: <code>--pick 1</code> is the design, 2 to 5 leave a "
         "usual "
         "stretch of 2, 1, 0.5 and 0.1 %, 6 is flat. <code>planish frontier</code> computes them "
         "all.</p>\n"
         "</section>\n";
}

}  // namespace planish
