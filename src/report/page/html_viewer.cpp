#include "report/page/html_viewer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include <planish/measure/flattenability.h>
#include <planish/sheet/pattern_sheet.h>

#include "core/figure_text.h"
#include "core/number_text.h"
#include "draw/svg/svg_layers.h"
#include "report/page/html_parts.h"
#include "report/page/legend.h"
#include "report/page/page_assets.h"
#include "report/page/page_data.h"
#include "report/pictures/patch_picture.h"
#include "report/pictures/pattern_picture.h"
#include "sheet/limit_map.h"
#include "sheet/stretch_directions.h"

namespace planish {

namespace {

constexpr int k_viewer_picture_width = 880;  // pixels: sharp at half of it
constexpr int k_direction_cells = 150;
constexpr double k_least_strain = 0.001;  // nobody can measure less on cloth or leather: no arrows

std::string figures_caption(std::string_view when, const Flattenability& figures) {
  return "<b>" + std::string(when) + "</b> worst place " + significant_text(figures.e_max, 2) +
         "\u00A0rad, in all " + significant_text(figures.sum_abs_defect, 2) + "\u00A0rad";
}

std::string still_pictures(const FlattenReport& report, const PatchPictures& pictures,
                           ColorMap colors) {
  const Image &before = pictures.before, &after = pictures.after.front();
  const std::string source = picture_source(before);
  return "<div class=\"still\">\n<div class=\"pair\">\n" +
         html_picture(before, source, "The input patch, coloured by angle defect",
                      figures_caption("Before:", report.evolve.before.figures)) +
         html_picture(after, after == before ? source : picture_source(after),
                      "The patch after evolving, coloured by angle defect",
                      figures_caption("After:", report.evolve.after.figures)) +
         "</div>\n" + legend(fields_of(colors), defect_labels(colors, pictures.limit)) + "</div>\n";
}

std::string line_key(std::string_view layer, std::string_view words,
                     const std::string& style = {}) {
  return "<li data-layer=\"" + std::string(layer) +
         "\"><svg viewBox=\"0 0 24 8\" aria-hidden=\"true\" "
         "class=\"key-" +
         std::string(layer) + "\"><path d=\"M0,4H24\"" + style + "/></svg>" + std::string(words) +
         "</li>\n";
}

struct FlatView {
  const Drawing& sheet;
  Layer directions;
  std::optional<MapLimit> limit;  ///< that the colours are for
};

/// What each line is, of the lines that are there.
std::string line_keys(const FlatView& view) {
  const auto& [sheet, directions, limit] = view;
  struct Line {
    std::string_view layer, words;
  };
  constexpr std::array<Line, 8> lines = {{{"cut", "cut line"},
                                          {"hole", "cut line of a hole"},
                                          {"seam", "seam line"},
                                          {"notch", "notch"},
                                          {"grain", "grain"},
                                          {"fold", "fold line"},
                                          {"drill", "drill hole"},
                                          {"internal", "inner line"}}};
  std::string html = "<ul class=\"lines\">\n";
  for (const Line& line : lines) {
    const bool is_there = std::any_of(
        sheet.layers.begin(), sheet.layers.end(),
        [&](const Layer& layer) { return layer.name == line.layer && !layer.shapes.empty(); });
    if (is_there) html += line_key(line.layer, line.words);
  }
  if (limit) {
    const std::string color = hex_text(limit_band_color(k_limit_bands / 2));
    html += line_key("strain", "limit used up in colour", " style=\"stroke:" + color + "\"");
  } else {
    html += line_key("strain", "stretch in colour");
  }
  if (!directions.shapes.empty())
    html += line_key("directions", "which way it is longer or shorter");
  return html + "</ul>\n";
}

FlatView flat_view(const FlattenReport& report, const PatternGeometry& drawn,
                   const Drawing& sheet) {
  const Pattern& pattern = report.unfold.pattern;
  const double mm = millimetres_per(report.unfold.unit);
  const Vec2 shift = drawn.positions.front() - mm * pattern.positions.front();
  auto directions =
      stretch_directions(report.processed.mesh(), pattern.positions, k_direction_cells);
  std::vector<double> sizes = {k_least_strain};
  for (StretchDirection& direction : directions) {
    direction.at = mm * direction.at + shift;
    sizes.push_back(std::abs(direction.strain));
  }
  // Of the longest arrows: a few places with more must not make all others too short to see.
  const auto long_one = sizes.begin() + static_cast<std::ptrdiff_t>(9 * (sizes.size() - 1) / 10);
  std::nth_element(sizes.begin(), long_one, sizes.end());
  const double longest = std::max(k_least_strain, *long_one);
  const double area = mm * mm * pattern.width * pattern.height;
  return {sheet, direction_layer(directions, longest, 0.9 * std::sqrt(area / k_direction_cells)),
          limit_of_edges(report.unfold.limits)};
}

std::string strain_legend(const UnfoldReport& unfold) {
  const double end = strain_map_limit(unfold.strain);
  const std::string limit =
      fixed_text(100.0 * end, 3) + "\u00A0%</b>" + (unfold.strain.max > end ? " or more" : "");
  return legend(strain_map_fields(), {"shorter <b>−" + limit, "<b>0</b>", "longer <b>+" + limit});
}

std::string pattern_part(const FlattenReport& report, const FlatView& view) {
  const PatternPicture picture =
      pattern_picture(view.sheet, view.directions,
                      view.limit ? "The pattern, coloured by the limit used up, with its lines"
                                 : "The pattern, coloured by strain, with its lines");
  const std::string note = view.limit ? "Colours show how much of the limit of strain (" +
                                            view.limit->words + ") the edges use up. "
                                      : "";
  const Pattern& pattern = report.unfold.pattern;
  const double mm = millimetres_per(report.unfold.unit);
  return "<div class=\"flat\">\n<h3>Pattern <small>" + significant_text(mm * pattern.width, 4) +
         " × " + significant_text(mm * pattern.height, 4) + "\u00A0mm; the bar is " +
         number_text(picture.bar) + "\u00A0mm</small></h3>\n<div class=\"sheet\">" + picture.svg +
         "</div>\n" + line_keys(view) +
         (view.limit ? limit_legend() : strain_legend(report.unfold)) + "<p class=\"note\">" +
         note +
         "Where the pattern is shorter than the patch, the material is stretched "
         "when it is made up; where it is longer, it is pressed together or "
         "gathered.</p>\n</div>\n";
}

/// What the page shows beside a limit.
std::string limit_terms(const MapLimit& limit) {
  return html_entry("Limit used up",
                    "|Strain| of the edge there whose length differs most, over the limit of " +
                        limit.words + ". 100 % is the limit; beyond it all is orange.") +
         html_entry("Longest, shortest way",
                    "Principal stretches, minus 1: how much longer (+) or shorter (−) the pattern "
                    "is there than the patch in the direction where it is longest, and across "
                    "that, where it is shortest; the mean around the place.");
}

std::string color_terms(const std::optional<MapLimit>& limit = {}) {
  return "<details class=\"terms\"><summary>What the colours mean, and the terms of the paper"
         "</summary>\n<dl>\n" +
         html_entry(
             "Dome or saddle",
             "Angle defect: what the angles around a vertex lack to a full turn, d = 2π − θ, "
             "radians. A dome lacks some, a saddle has too much; 0 lies flat.") +
         html_entry(
             "Curvature",
             "|Gaussian curvature| as in Eq. 1 of the 2010 paper: the angle defect over a third "
             "of the area around the vertex, from blue to red as the paper shows it. Of the same "
             "size as a ball's of the radius given. Blue to red is not safe for colour-blind "
             "eyes; all other scales are.") +
         html_entry(
             "Bent",
             "Curvature across the edges, as of a cylinder of the radius given, on one scale: "
             "what is darker after than before is new.") +
         html_entry("Offset",
                    "How far the place went along the normal of the design: outwards (+) to the "
                    "side that the normals point to, inwards (−) to the other.") +
         html_entry("Moved", "Deviation: how far the place went from where it was, any way.") +
         html_entry(
             "Stretch",
             "Strain: how much longer (+) or shorter (−) the pattern is there than the patch, "
             "in the direction where it is most; the mean around the place.") +
         html_entry("Largest stretch",
                    "Strain of the edge there whose length differs most. The "
                    "worst of all is the figure at the top of the page.") +
         (limit ? limit_terms(*limit) : "") + "</dl></details>\n";
}

std::string data_of(const FlattenReport& report, const PatternGeometry& pattern,
                    double defect_limit) {
  std::vector<Vec2> drawn = pattern.positions;
  for (Vec2& p : drawn)
    p.y = pattern.sheet_size.y - p.y;
  PageInput input{{{"before", report.input, report.design_pattern.pattern.positions},
                   {"after", report.processed, report.unfold.pattern.positions}}};
  input.unit = report.unfold.unit;
  input.defect_limit = defect_limit;
  input.strain_limit = strain_map_limit(report.unfold.strain);
  input.limit = limit_of_edges(report.unfold.limits);
  input.source = report.source;
  input.drawn = drawn;
  return page_data(input);
}

}  // namespace

PatchViewer html_viewer(const CompareReport& report) {
  if (!page_script().is_there()) return {};
  PageInput input{{{"input", report.input}}};
  input.defect_limit = defect_limit(angle_defects(report.input), report.input.connectivity());
  if (report.design_least_stretch) {
    input.unit = report.design_least_stretch->unit;
    input.states.front().pattern = report.design_least_stretch->pattern.positions;
    input.strain_limit = strain_map_limit(report.design_least_stretch->strain);
  }
  const auto best = best_run(report);
  for (const ComparedMethod& method : report.runs) {
    if (!method.evolve) continue;
    if (best && &method == &report.runs[*best]) input.shown = input.states.size();
    PageState state{std::string(name_of(method.run.method)),
                    report.input.with_positions(method.evolve->result.positions)};
    if (method.unfold) state.pattern = method.unfold->pattern.positions;
    input.states.push_back(std::move(state));
  }
  if (input.states.size() < 2) return {};
  return {
      "<section class=\"bench solo\" id=\"bench\">\n<div class=\"patch\">\n<h2>The results in "
      "space</h2>\n<p>The input patch on one side, what a method made of it on the other, in "
      "one view and with one scale.</p>\n<div id=\"stage\"></div>\n</div>\n" +
          color_terms() + "</section>\n",
      page_data(input)};
}

PatchViewer html_viewer(const FlattenReport& report, const PatternGeometry& pattern,
                        const Drawing& sheet, ColorMap colors) {
  const std::array<std::span<const Vec3>, 1> after = {report.processed.positions()};
  const PatchPictures pictures =
      patch_pictures(report.input, after, colors, k_viewer_picture_width);
  const bool live = page_script().is_there();
  PatchViewer viewer;
  viewer.html =
      "<section class=\"bench keep\" id=\"bench\">\n<div class=\"patch\">\n<h3>Form <small>the "
      "design "
      "before, the result after; both turn together</small></h3>\n<div id=\"stage\"></div>\n" +
      still_pictures(report, pictures, colors) +
      (live ? ""
            : "<p class=\"note\">The view that can be turned was left out when this program "
              "was built (it takes Node.js).</p>\n") +
      "</div>\n" + pattern_part(report, flat_view(report, pattern, sheet)) +
      color_terms(limit_of_edges(report.unfold.limits)) + "</section>\n";
  if (live) viewer.data = data_of(report, pattern, pictures.limit);
  return viewer;
}

}  // namespace planish
