#include "draw/dxf/dxf_entities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "draw/dxf/dxf_places.h"

namespace planish {

namespace {

// AutoCAD's first nine colours, from number 1 on. It shows 7 as black on white and white on black.
constexpr std::array<Color, 9> k_colors = {{{255, 0, 0},
                                            {255, 255, 0},
                                            {0, 255, 0},
                                            {0, 255, 255},
                                            {0, 0, 255},
                                            {255, 0, 255},
                                            {0, 0, 0},
                                            {128, 128, 128},
                                            {192, 192, 192}}};

}  // namespace

int color_number(Color color) {
  const auto distance = [&](Color other) {
    const int r = color.r - other.r, g = color.g - other.g, b = color.b - other.b;
    return r * r + g * g + b * b;
  };
  const auto* const nearest =
      std::min_element(k_colors.begin(), k_colors.end(),
                       [&](Color a, Color b) { return distance(a) < distance(b); });
  return static_cast<int>(nearest - k_colors.begin()) + 1;
}

void DxfEntities::add(const Layer& layer, const std::string& name) {
  for (const DrawingShape& shape : layer.shapes)
    std::visit([&](const auto& some) { add(some, name, layer.visible); }, shape);
}

// The tags of how an entity looks, where its layer looks otherwise.
DxfTags DxfEntities::looks_on(const std::string& layer, Color color, bool dashed, bool visible) {
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

void DxfEntities::add(const Path& path, const std::string& layer, bool visible) {
  if (!path.stroke) return;
  const std::span<const std::vector<Vec2>> lines =
      path.fitted.few.empty() ? path.lines : path.fitted.few;
  DxfTags& tags = pieces_[path.piece];
  for (const std::vector<Vec2>& line : dxf_places(lines, path.closed)) {
    tags.add_polyline(layer, line, path.closed,
                      looks_on(layer, path.stroke->color, path.stroke->dashed, visible));
    for (const Vec2 place : line)
      box_.add(place);
  }
}

void DxfEntities::add(const Text& text, const std::string& layer, bool visible) {
  if (text.text.empty() || !std::isfinite(text.at.x) || !std::isfinite(text.at.y)) return;
  DxfTags& tags = pieces_[text.piece];
  tags.add(0, "TEXT");
  tags.add(8, layer);
  tags.append(looks_on(layer, text.color, false, visible));
  tags.add_point(10, text.at);
  tags.add_real(40, text.height);
  tags.add(1, dxf_text(text.text));
  if (text.centred) {
    tags.add(72, 1);
    tags.add_point(11, text.at);
  }
  box_.add(text.at);
}

DxfTags DxfEntities::tags() const {
  DxfTags all;
  for (const auto& [piece, tags] : pieces_)
    all.append(tags);
  return all;
}

}  // namespace planish
