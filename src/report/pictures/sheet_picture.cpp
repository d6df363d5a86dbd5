#include "report/pictures/sheet_picture.h"

#include <algorithm>
#include <set>
#include <variant>
#include <vector>

#include "core/number_text.h"
#include "draw/svg/svg_layers.h"
#include "draw/text/markup_text.h"

namespace planish {

namespace {

/// The names of the pieces are the first text of each. Further lines would lie over them, as names
/// are larger here than on the sheet.
Layer with_names_only(Layer layer) {
  std::set<std::size_t> named;
  const auto is_left_out = [&](const DrawingShape& shape) {
    const auto* text = std::get_if<Text>(&shape);
    return text != nullptr && (layer.name != "annotation" || !named.insert(text->piece).second);
  };
  layer.shapes.erase(std::remove_if(layer.shapes.begin(), layer.shapes.end(), is_left_out),
                     layer.shapes.end());
  return layer;
}

}  // namespace

std::string sheet_picture(const Drawing& sheet, std::size_t number, const std::string& label) {
  constexpr double lines_of_text = 36.0;  // in the shorter side
  const std::string prefix = "sheet-" + std::to_string(number) + "-";
  std::vector<Layer> layers;
  for (const Layer& layer : sheet.layers) {
    layers.push_back(with_names_only(layer));
    layers.back().name = prefix + layer.name;
  }
  const std::string width = fixed_text(sheet.width, 3), height = fixed_text(sheet.height, 3);
  const double text = std::min(sheet.width, sheet.height) / lines_of_text;
  return "<svg class=\"sheet\" role=\"img\" aria-label=\"" + escape_markup(label) +
         "\" viewBox=\"0 0 " + width + ' ' + height + "\" style=\"--text: " + fixed_text(text, 1) +
         "px\">\n" + svg_layers(layers, sheet.height) + "</svg>\n";
}

}  // namespace planish
