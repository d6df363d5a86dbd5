#include "draw/dxf/dxf_layers.h"

#include <algorithm>
#include <array>

namespace planish {

namespace {

struct NumberedColor {
  int number;
  Color color;
};

// Of AutoCAD's colours the first nine, and what keeps the layers of sheets apart. It shows 7 as
// black on white and white on black.
constexpr std::array<NumberedColor, 16> k_colors = {{{1, {255, 0, 0}},
                                                     {2, {255, 255, 0}},
                                                     {3, {0, 255, 0}},
                                                     {4, {0, 255, 255}},
                                                     {5, {0, 0, 255}},
                                                     {6, {255, 0, 255}},
                                                     {7, {0, 0, 0}},
                                                     {8, {128, 128, 128}},
                                                     {9, {192, 192, 192}},
                                                     {12, {165, 0, 0}},
                                                     {30, {255, 127, 0}},
                                                     {32, {165, 82, 0}},
                                                     {34, {127, 63, 0}},
                                                     {42, {165, 124, 0}},
                                                     {54, {127, 127, 0}},
                                                     {192, {82, 0, 165}}}};

/// The nearest of them.
int color_number(Color color) {
  const auto distance = [&](Color other) {
    const int r = color.r - other.r, g = color.g - other.g, b = color.b - other.b;
    return r * r + g * g + b * b;
  };
  const auto* const nearest = std::min_element(
      k_colors.begin(), k_colors.end(),
      [&](const auto& a, const auto& b) { return distance(a.color) < distance(b.color); });
  return nearest->number;
}

}  // namespace

DxfTags DxfLayers::looks_on(const std::string& layer, Color color, bool dashed, bool visible) {
  const int number = color_number(color);
  auto found = std::find_if(layers_.begin(), layers_.end(),
                            [&](const DxfLayer& some) { return some.name == layer; });
  if (found == layers_.end()) found = layers_.insert(found, {layer, number, false});
  found->visible = found->visible || visible;
  DxfTags tags;
  if (dashed) tags.add(6, "DASHED");
  if (number != found->color) tags.add(62, number);
  return tags;
}

std::vector<DxfLayer> DxfLayers::with_layer_0() const {
  std::vector<DxfLayer> layers = layers_;
  const auto is_it = [](const DxfLayer& layer) { return layer.name == "0"; };
  if (std::none_of(layers.begin(), layers.end(), is_it)) layers.insert(layers.begin(), {"0"});
  return layers;
}

}  // namespace planish
