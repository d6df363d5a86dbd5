#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include <planish/sheet/nest_sheet.h>

#include "pattern/polygon/loop_box.h"
#include "pattern/polygon/polygon_edges.h"
#include "sheet/piece/line_path.h"

namespace planish {

namespace {

constexpr double k_on_line = 1e-3;  // millimetres, as files are written

/// A stretch of an edge, by the way from its first point.
struct EdgeStretch {
  double from, to;
};

bool is_near(const LoopBox& box, Vec2 a, Vec2 b) {
  return std::min(a.x, b.x) <= box.high.x + k_on_line &&
         std::max(a.x, b.x) >= box.low.x - k_on_line &&
         std::min(a.y, b.y) <= box.high.y + k_on_line &&
         std::max(a.y, b.y) >= box.low.y - k_on_line;
}

/// The stretch of an edge that another one lies on.
std::optional<EdgeStretch> stretch_under(Vec2 a, Vec2 b, const PolygonEdge& other) {
  const double length = norm(b - a);
  if (!(length > 0.0)) return std::nullopt;
  const Vec2 along = 1.0 / length * (b - a);
  const auto is_off = [&](Vec2 p) { return !(std::abs(cross(along, p - a)) <= k_on_line); };
  if (is_off(other.a) || is_off(other.b)) return std::nullopt;
  const double first = dot(other.a - a, along), last = dot(other.b - a, along);
  const EdgeStretch stretch = {std::max(0.0, std::min(first, last)),
                               std::min(length, std::max(first, last))};
  if (!(stretch.to - stretch.from > k_on_line)) return std::nullopt;
  return stretch;
}

/// The lines of a piece, or of the sheet, with the box around them.
struct PieceLines {
  LoopBox box;
  std::vector<PolygonEdge> edges;
};

/// The stretches of an edge that no line lies on.
std::vector<EdgeStretch> free_stretches(Vec2 a, Vec2 b, std::span<const PieceLines* const> drawn) {
  std::vector<EdgeStretch> taken;
  for (const PieceLines* lines : drawn) {
    if (!is_near(lines->box, a, b)) continue;
    for (const PolygonEdge& edge : lines->edges) {
      if (const auto stretch = stretch_under(a, b, edge)) taken.push_back(*stretch);
    }
  }
  std::sort(taken.begin(), taken.end(), [](const EdgeStretch& one, const EdgeStretch& two) {
    return std::pair(one.from, one.to) < std::pair(two.from, two.to);
  });
  std::vector<EdgeStretch> free;
  double reached = 0.0;
  for (const EdgeStretch& stretch : taken) {
    if (stretch.from > reached + k_on_line) free.push_back({reached, stretch.from});
    reached = std::max(reached, stretch.to);
  }
  const double length = norm(b - a);
  if (taken.empty() || length > reached + k_on_line) free.push_back({reached, length});
  return free;
}

/// What is left of a closed line, as open lines; nothing where all of it is.
std::optional<std::vector<Polygon>> rest_of(const Polygon& loop,
                                            std::span<const PieceLines* const> drawn) {
  std::vector<Polygon> lines;
  bool is_whole = true, goes_on = false, begins_at_start = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 a = loop[i], b = loop[(i + 1) % loop.size()];
    const double length = norm(b - a);
    const std::vector<EdgeStretch> free = free_stretches(a, b, drawn);
    const bool starts_free = !free.empty() && free.front().from == 0.0;
    if (i == 0) begins_at_start = starts_free;
    goes_on = goes_on && starts_free;
    for (const EdgeStretch& stretch : free) {
      const auto at = [&](double way) {
        return way == length ? b : a + (length > 0.0 ? way / length : 0.0) * (b - a);
      };
      if (!goes_on) lines.push_back({at(stretch.from)});
      lines.back().push_back(at(stretch.to));
      goes_on = stretch.to == length;
    }
    goes_on = goes_on && !free.empty();
    is_whole = is_whole && free.size() == 1 && starts_free && free.front().to == length;
  }
  if (is_whole) return std::nullopt;
  if (goes_on && begins_at_start && lines.size() > 1) {
    lines.back().insert(lines.back().end(), lines.front().begin() + 1, lines.front().end());
    lines.front() = std::move(lines.back());
    lines.pop_back();
  }
  return lines;
}

bool touch(const LoopBox& a, const LoopBox& b) {
  return is_near(a, b.low, b.high);
}

/// A closed path without what is drawn already: as it is, or what is left as closed and open paths.
std::vector<Path> rest_of(const Path& path, std::span<const PieceLines> drawn) {
  const LoopBox box = loop_box(path.lines);
  std::vector<const PieceLines*> near;
  for (const PieceLines& lines : drawn) {
    if (touch(lines.box, box)) near.push_back(&lines);
  }
  Path closed = path, open = path;
  open.closed = false;
  open.fitted = {};
  open.lines.clear();
  for (std::size_t k = path.lines.size(); k-- > 0;) {
    auto rest = rest_of(path.lines[k], near);
    if (!rest) continue;
    closed.lines.erase(closed.lines.begin() + static_cast<std::ptrdiff_t>(k));
    closed.fitted = without_line(std::move(closed.fitted), k);
    open.lines.insert(open.lines.end(), rest->begin(), rest->end());
  }
  std::vector<Path> paths;
  if (!closed.lines.empty()) paths.push_back(std::move(closed));
  if (!open.lines.empty()) paths.push_back(std::move(open));
  return paths;
}

void leave_out_drawn(Layer& layer, std::vector<PieceLines>& drawn, bool is_drawn_then) {
  std::vector<DrawingShape> shapes;
  shapes.reserve(layer.shapes.size());
  for (DrawingShape& shape : layer.shapes) {
    const auto* path = std::get_if<Path>(&shape);
    if (path == nullptr || !path->closed) {
      shapes.push_back(std::move(shape));
      continue;
    }
    for (Path& rest : rest_of(*path, drawn))
      shapes.emplace_back(std::move(rest));
    if (is_drawn_then) drawn.push_back({loop_box(path->lines), polygon_edges(path->lines)});
  }
  layer.shapes = std::move(shapes);
}

}  // namespace

Drawing without_common_lines(Drawing layout) {
  std::vector<PieceLines> cut;
  for (const std::string_view name : {"cut", "hole", "label"}) {
    for (Layer& layer : layout.layers) {
      if (layer.name == name) leave_out_drawn(layer, cut, name != "label");
    }
  }
  return layout;
}

}  // namespace planish
