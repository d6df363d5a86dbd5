// The pattern of least stretch beside one that keeps a limit of strain, both coloured by how much
// of the limit their edges use up, in limits.svg. Without arguments: of a built-in panel.
//   example_04_limits [MESH LIMIT]
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <iostream>
#include <string>
#include <utility>

#include <planish/draw/color.h>
#include <planish/draw/format_drawing.h>
#include <planish/io/read_mesh.h>
#include <planish/io/write_file.h>
#include <planish/mesh/shapes.h>
#include <planish/sheet/pattern_sheet.h>

namespace {

using planish::Vec2;

std::string percent(double share) {
  std::array<char, 40> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), 100.0 * share,
                                 std::chars_format::general, 3);
  return std::string(text.data(), end.ptr) + " %";
}

constexpr double k_width = 100.0, k_gap = 4.0, k_foot = 17.0;  // of a pattern, around it, below

double scale_of(const planish::UnfoldReport& report) {
  return k_width / (millimetres_per(report.unit) * report.pattern.width);
}

// The map and the outline of a pattern, as wide as all others.
planish::Layer picture_of(const planish::Patch& patch, const planish::UnfoldReport& report,
                          Vec2 corner) {
  const planish::Drawing sheet = pattern_sheet(patch, report, "");
  const double scale = scale_of(report);
  Vec2 low = {sheet.width, sheet.height};  // of the first shape, which is the whole pattern
  planish::Layer picture{"pattern", {}};
  for (const planish::Layer& layer : sheet.layers) {
    if (layer.name != "strain" && layer.name != "cut") continue;
    for (const planish::DrawingShape& shape : layer.shapes) {
      auto path = std::get<planish::Path>(shape);
      for (const auto& line : path.lines) {
        for (const Vec2 p : line)
          low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      }
      for (auto& line : path.lines) {
        for (Vec2& p : line)
          p = corner + scale * (p - low);
      }
      if (path.stroke) path.stroke = planish::Stroke{{60, 60, 60}, 0.2};
      picture.shapes.emplace_back(std::move(path));
    }
  }
  return picture;
}

planish::Layer legend(Vec2 at, double limit) {
  constexpr double field = 8.0, height = 3.5, letters = 2.6;
  planish::Layer layer{"legend", {}};
  const auto add = [&](double left, double width, planish::Color color) {
    const double right = left + width, top = at.y + height;
    planish::Path path{{{{left, at.y}, {right, at.y}, {right, top}, {left, top}}}, true, {}, color};
    layer.shapes.emplace_back(std::move(path));
  };
  const auto label = [&](double middle, const std::string& text) {
    const Vec2 below = {middle, at.y - 3.6};
    layer.shapes.emplace_back(planish::Text{below, letters, text, {60, 60, 60}, true});
  };
  for (int i = 0; i < 10; ++i)
    add(at.x + i * field, field, color_at(planish::ColorMap::pale, (i + 0.5) / 10.0));
  const double end = at.x + 10.0 * field;
  add(end + k_gap, 20.0, planish::k_beyond_limit);
  label(at.x + 12.0, "limit used up: 0");
  label(at.x + 5.0 * field, "50 %");
  label(end - 13.0, "100 %, " + percent(limit) + " strain");
  label(end + k_gap + 10.0, "beyond");
  return layer;
}

}  // namespace

int main(int count, char** arguments) {
  const bool is_given = count == 3;
  const planish::Patch patch(is_given ? planish::read_mesh(arguments[1]).mesh
                                      : planish::make_shape("panel", 1000));
  const planish::StrainLimits limits = {.max = is_given ? std::atof(arguments[2]) : 0.02};

  auto least = planish::unfold_patch(patch, planish::Unit::mm, {.least_stretch = true});
  auto within = planish::unfold_patch(patch, planish::Unit::mm, {.limits = limits});
  // A limit that the pattern was not made for colours its map all the same.
  least.limits = check_limits(patch, least.pattern.positions, limits);

  const std::array captions = {
      "least stretch: up to " + percent(least.strain.max),
      "every edge within " + percent(limits.max) + ": up to " + percent(within.strain.max)};
  planish::Drawing drawing{"Limits of strain", 2.0 * k_width + 3.0 * k_gap, 0.0, {}};
  double left = k_gap;
  for (const auto& [report, caption] :
       {std::pair(&least, captions[0]), std::pair(&within, captions[1])}) {
    planish::Layer picture = picture_of(patch, *report, {left, k_foot});
    picture.shapes.emplace_back(
        planish::Text{{left + 0.5 * k_width, k_foot - 6.0}, 3.4, caption, {30, 30, 30}, true});
    drawing.layers.push_back(std::move(picture));
    const double height =
        scale_of(*report) * millimetres_per(report->unit) * report->pattern.height;
    drawing.height = std::max(drawing.height, k_foot + height + k_gap);
    left += k_width + k_gap;
    std::cout << caption << '\n';
  }
  drawing.layers.push_back(legend({0.5 * drawing.width - 52.0, 4.8}, limits.max));
  planish::write_files(std::array{planish::OutputFile{"limits.svg", format_svg(drawing)}});
}
