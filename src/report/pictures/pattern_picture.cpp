#include "report/pictures/pattern_picture.h"

#include <algorithm>
#include <cmath>

#include "core/number_text.h"
#include "draw/scale_limit.h"
#include "draw/svg/svg_layers.h"
#include "draw/text/markup_text.h"
#include "pattern/polygon/loop_box.h"

namespace planish {

namespace {

LoopBox box_of(const Layer& layer) {
  std::vector<Polygon> lines;
  for (const DrawingShape& shape : layer.shapes) {
    const auto* path = std::get_if<Path>(&shape);
    if (path != nullptr) lines.insert(lines.end(), path->lines.begin(), path->lines.end());
  }
  return loop_box(lines);
}

}  // namespace

PatternPicture pattern_picture(const Drawing& sheet, const Layer& directions,
                               const std::string& label) {
  std::vector<Layer> layers;
  LoopBox box = {{0.0, 0.0}, {sheet.width, sheet.height}};
  for (const Layer& layer : sheet.layers) {
    if (layer.name == "cut") box = box_of(layer);
    if (layer.name != "label" && layer.name != "legend") layers.push_back(layer);
    if (layer.name == "strain") layers.push_back(directions);
  }
  const auto [width, height] = box.size();
  const double pad = 0.012 * std::max(width, height);
  const double bar_length = round_up_125(std::max(width, 1e-6) / 10.0);
  const double bar_y = box.low.y - 3.0 * pad;
  layers.push_back({"bar",
                    {Path{{{{box.low.x, bar_y + pad},
                            {box.low.x, bar_y},
                            {box.low.x + bar_length, bar_y},
                            {box.low.x + bar_length, bar_y + pad}}},
                          false,
                          Stroke{}}}});

  std::string svg =
      "<svg class=\"pattern\" role=\"img\" aria-label=\"" + escape_markup(label) + "\" viewBox=\"";
  for (const double number :
       {box.low.x - pad, sheet.height - box.high.y - pad, width + 2.0 * pad}) {
    append_fixed(svg, number, 3);
    svg += ' ';
  }
  append_fixed(svg, height + 5.0 * pad, 3);
  svg += "\">\n" + svg_layers(layers, sheet.height) + "</svg>\n";
  return {std::move(svg), bar_length};
}

}  // namespace planish
