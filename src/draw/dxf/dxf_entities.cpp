#include "draw/dxf/dxf_entities.h"

#include <cmath>
#include <span>

namespace planish {

void DxfEntities::add(const Layer& layer, const std::string& name) {
  for (const DrawingShape& shape : layer.shapes)
    std::visit([&](const auto& some) { add(some, name, layer.visible); }, shape);
}

void DxfEntities::add(const Path& path, const std::string& layer, bool visible) {
  if (!path.stroke) return;
  const std::span<const std::vector<Vec2>> lines =
      path.fitted.few.empty() ? path.lines : path.fitted.few;
  for (const std::vector<Vec2>& line : dxf_places(lines, path.closed)) {
    tags_.add_polyline(layer, line, path.closed,
                       layers_.looks_on(layer, path.stroke->color, path.stroke->dashed, visible));
    for (const Vec2 place : line)
      box_.add(place);
  }
}

void DxfEntities::add(const Text& text, const std::string& layer, bool visible) {
  if (text.text.empty() || !std::isfinite(text.at.x) || !std::isfinite(text.at.y)) return;
  tags_.add(0, "TEXT");
  tags_.add(8, layer);
  tags_.append(layers_.looks_on(layer, text.color, false, visible));
  tags_.add_words(text);
  box_.add(text.at);
}

}  // namespace planish
