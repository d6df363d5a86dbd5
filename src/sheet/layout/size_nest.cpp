#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <planish/core/error.h>
#include <planish/sheet/nest_sheet.h>

#include "core/math.h"
#include "pattern/polygon/loop_box.h"
#include "sheet/annotations.h"
#include "sheet/piece/placed_pattern.h"
#include "sheet/sheet_layout.h"

namespace planish {

namespace {

constexpr std::array<Color, 6> k_size_colors = {
    {{0, 90, 181}, {200, 30, 30}, {0, 133, 66}, {170, 68, 0}, {120, 60, 160}, {0, 130, 140}}};
constexpr double k_line_height = 5.0, k_pitch = 8.0;  // of the list of sizes, millimetres

/// A turn about one place that is then shifted to another one.
struct Motion {
  Vec2 from, to, x;  ///< x: where (1, 0) turns to

  Vec2 operator()(Vec2 p) const {
    const Vec2 q = p - from;
    return to + Vec2{q.x * x.x - q.y * x.y, q.x * x.y + q.y * x.x};
  }
};

Vec2 mean_of(const std::vector<Vec2>& places) {
  Vec2 sum;
  for (const Vec2 p : places)
    sum = sum + p;
  return 1.0 / static_cast<double>(places.size()) * sum;
}

/// The motion that brings places nearest to others of the same numbers, by the sum of the squares
/// of their distances.
Motion best_motion(const std::vector<Vec2>& places, const std::vector<Vec2>& others) {
  Motion motion{mean_of(places), mean_of(others), {1.0, 0.0}};
  double along = 0.0, across = 0.0;
  for (std::size_t v = 0; v < places.size(); ++v) {
    const Vec2 p = places[v] - motion.from, q = others[v] - motion.to;
    along += dot(p, q);
    across += cross(p, q);
  }
  const double angle = math::atan2(across, along);
  motion.x = {math::cos(angle), math::sin(angle)};
  return motion;
}

std::string name_of(const NestPatch& patch) {
  const std::string& size = patch.annotations.label.size;
  return size.empty() ? patch.name : size;
}

/// Lines of a piece in one colour on one layer.
Layer size_layer(const std::string& name, std::vector<Layer> layers, Color color) {
  Layer all{name, {}};
  for (Layer& layer : layers) {
    if (layer.name == "annotation" || layer.name == "grain") continue;
    for (DrawingShape& shape : layer.shapes) {
      auto* path = std::get_if<Path>(&shape);
      if (path == nullptr || !path->stroke) continue;
      path->stroke->color = color;
      all.shapes.emplace_back(std::move(*path));
    }
  }
  return all;
}

}  // namespace

Drawing size_nest(std::span<const NestPatch> sizes, Unit unit, const std::string& title) {
  Drawing sheet{title, 0.0, 0.0, {}};
  if (sizes.empty()) return sheet;
  std::vector<PatternGeometry> patterns;
  for (const NestPatch& size : sizes) {
    if (size.mesh.triangles != sizes.front().mesh.triangles)
      throw Error(ErrorCode::option_out_of_range,
                  "\"" + size.name + "\" has not the triangles of \"" + sizes.front().name + "\"");
    patterns.push_back(placed_pattern(size.mesh, size.pattern, unit, size.name, size.annotations));
  }
  const std::vector<Vec2> middle = patterns[patterns.size() / 2].positions;
  for (PatternGeometry& pattern : patterns) {
    const Motion motion = best_motion(pattern.positions, middle);
    pattern = moved(std::move(pattern), motion);
  }
  LoopBox box = loop_box(patterns.front().cut);
  for (const PatternGeometry& pattern : patterns) {
    const LoopBox own = loop_box(pattern.cut);
    box.low = {std::min(box.low.x, own.low.x), std::min(box.low.y, own.low.y)};
    box.high = {std::max(box.high.x, own.high.x), std::max(box.high.y, own.high.y)};
  }
  const double words = k_pitch * static_cast<double>(patterns.size() + 1);
  const double below = std::max(words, sheet::k_square) + sheet::k_gap;
  const Vec2 shift = Vec2{sheet::k_margin, sheet::k_margin + below} - box.low;
  sheet.width = std::max(box.size().x, 3.0 * sheet::k_square) + 2.0 * sheet::k_margin;
  sheet.height = box.size().y + below + 2.0 * sheet::k_margin;
  Layer label{"label", {}};
  const double left = sheet::k_column, top = sheet::k_margin + std::max(words, sheet::k_square);
  label.shapes.emplace_back(
      Text{{left, top - k_line_height}, k_line_height, title, sheet::k_label_color});
  const Vec2 low = {sheet::k_margin, sheet::k_margin};
  const double side = sheet::k_square;
  label.shapes.emplace_back(
      Path{{{low, low + Vec2{side, 0.0}, low + Vec2{side, side}, low + Vec2{0.0, side}}},
           true,
           Stroke{sheet::k_label_color}});
  for (std::size_t k = 0; k < patterns.size(); ++k) {
    const Color color = k_size_colors[k % k_size_colors.size()];
    patterns[k] = moved(std::move(patterns[k]), [&](Vec2 p) { return p + shift; });
    const std::string name = name_of(sizes[k]);
    const double line = top - k_pitch * static_cast<double>(k + 1) - k_line_height;
    label.shapes.emplace_back(Text{{left, line}, k_line_height, name, color});
    sheet.layers.push_back(
        size_layer(name, piece_layers(annotated(std::move(patterns[k]), sizes[k].mesh)), color));
  }
  sheet.layers.push_back(std::move(label));
  sheet.pieces.push_back({title});
  return sheet;
}

}  // namespace planish
