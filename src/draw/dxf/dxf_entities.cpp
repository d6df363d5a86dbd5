#include "draw/dxf/dxf_entities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "draw/dxf/dxf_profile.h"
#include "draw/whole_steps.h"

namespace planish {

namespace {

constexpr double k_steps = 1000.0;  // per millimetre

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

std::vector<std::vector<Vec2>> places_of(const Path& path) {
  std::vector<std::vector<Vec2>> lines;
  lines.reserve(path.lines.size());
  for (const auto& line : path.lines) {
    std::vector<Vec2> places = whole_steps(line, k_steps, path.closed);
    for (Vec2& place : places)
      place = {place.x / k_steps, place.y / k_steps};
    if (places.size() > 1) lines.push_back(std::move(places));
  }
  return lines;
}

double area(const std::vector<Vec2>& loop) {
  double doubled = 0.0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    doubled += cross(loop[i] - loop[0], loop[i + 1] - loop[0]);
  return 0.5 * std::abs(doubled);
}

std::size_t largest_of(const std::vector<std::vector<Vec2>>& loops) {
  const auto largest = std::max_element(
      loops.begin(), loops.end(), [](const auto& a, const auto& b) { return area(a) < area(b); });
  return static_cast<std::size_t>(largest - loops.begin());
}

}  // namespace

void DxfEntities::add(const Layer& layer, const std::string& name) {
  for (const DrawingShape& shape : layer.shapes)
    std::visit([&](const auto& some) { add(some, name, layer.visible); }, shape);
}

// The tags that tell how an entity looks, where that is not how its layer does.
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
  const auto lines = places_of(path);
  if (lines.empty()) return;
  DxfTags& tags = pieces_[path.piece];
  const bool splits = numbered_ && path.closed && layer == k_boundary_layer;
  const std::size_t boundary = splits ? largest_of(lines) : 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string line_layer(splits && i != boundary ? k_cutout_layer : layer);
    const DxfTags looks = looks_on(line_layer, path.stroke->color, path.stroke->dashed, visible);
    add_polyline(tags, lines[i], looks, line_layer, path.closed);
    for (const Vec2 place : lines[i])
      stretch_box(path.piece, place);
  }
}

void DxfEntities::add_polyline(DxfTags& tags, const std::vector<Vec2>& places, const DxfTags& looks,
                               const std::string& layer, bool closed) {
  tags.add(0, "POLYLINE");
  tags.add(8, layer);
  tags.append(looks);
  tags.add(66, 1);  // vertices follow
  tags.add_point(10, {});
  tags.add(70, closed ? 1 : 0);
  for (const Vec2 place : places) {
    tags.add(0, "VERTEX");
    tags.add(8, layer);
    tags.add_point(10, place);
  }
  tags.add(0, "SEQEND");
  tags.add(8, layer);
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
  stretch_box(text.piece, text.at);
}

void DxfEntities::stretch_box(std::size_t piece, Vec2 point) {
  const auto [entry, is_new] = boxes_.try_emplace(piece, point, point);
  auto& [low, high] = entry->second;
  low = {std::min(low.x, point.x), std::min(low.y, point.y)};
  high = {std::max(high.x, point.x), std::max(high.y, point.y)};
}

std::optional<std::pair<Vec2, Vec2>> DxfEntities::box_of(std::size_t piece) const {
  const auto found = boxes_.find(piece);
  if (found == boxes_.end()) return std::nullopt;
  return found->second;
}

std::optional<std::pair<Vec2, Vec2>> DxfEntities::box() const {
  std::optional<std::pair<Vec2, Vec2>> all;
  for (const auto& [piece, box] : boxes_) {
    if (!all) all = box;
    const auto [low, high] = box;
    all->first = {std::min(all->first.x, low.x), std::min(all->first.y, low.y)};
    all->second = {std::max(all->second.x, high.x), std::max(all->second.y, high.y)};
  }
  return all;
}

}  // namespace planish
