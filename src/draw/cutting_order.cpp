#include "draw/cutting_order.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <span>
#include <utility>
#include <variant>

#include <planish/pattern/piece_outline.h>

namespace planish {

namespace {

/// 0 of one with a point that is nowhere.
double area_within(std::span<const Vec2> loop) {
  const double area = std::abs(signed_area(loop));
  return std::isfinite(area) ? area : 0.0;
}

template <class Line>
std::vector<Line> in_order(std::vector<Line> lines, std::span<const std::size_t> order) {
  if (lines.size() != order.size()) return lines;  // nothing was fitted
  std::vector<Line> sorted;
  sorted.reserve(lines.size());
  for (const std::size_t number : order)
    sorted.push_back(std::move(lines[number]));
  return sorted;
}

}  // namespace

Path inner_first(Path path) {
  if (!path.closed || path.lines.size() < 2) return path;
  std::vector<double> areas;
  areas.reserve(path.lines.size());
  for (const auto& line : path.lines)
    areas.push_back(area_within(line));
  std::vector<std::size_t> order(areas.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return areas[a] < areas[b]; });
  path.lines = in_order(std::move(path.lines), order);
  path.fitted.few = in_order(std::move(path.fitted.few), order);
  path.fitted.curves = in_order(std::move(path.fitted.curves), order);
  return path;
}

std::vector<Layer> in_cutting_order(const Drawing& drawing) {
  std::map<std::size_t, std::vector<Layer>> pieces;
  for (const Layer& layer : drawing.layers) {
    std::map<std::size_t, Layer> parts;
    const auto add = [&](std::size_t piece, DrawingShape shape) {
      Layer& part = parts.try_emplace(piece, Layer{layer.name, {}, layer.visible}).first->second;
      part.shapes.push_back(std::move(shape));
    };
    for (const DrawingShape& shape : layer.shapes) {
      if (const auto* path = std::get_if<Path>(&shape)) {
        add(path->piece, inner_first(*path));
      } else {
        add(std::get<Text>(shape).piece, shape);
      }
    }
    for (auto& [piece, part] : parts)
      pieces[piece].push_back(std::move(part));
  }
  std::vector<Layer> order;
  for (auto& [piece, layers] : pieces)
    std::move(layers.begin(), layers.end(), std::back_inserter(order));
  return order;
}

}  // namespace planish
