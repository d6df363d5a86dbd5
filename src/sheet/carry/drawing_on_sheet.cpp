#include "sheet/carry/drawing_on_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <planish/core/error.h>

#include "core/figure_text.h"
#include "pattern/polygon/loop_box.h"
#include "pattern/polygon/plane.h"
#include "sheet/piece/line_path.h"
#include "sheet/sheet_layout.h"

namespace planish {

namespace {

// Millimetres: sheets have thousandths, other programs fewer digits.
constexpr double k_near = 0.02;
// Millimetres that a fitted outline may be off the border, with something to spare.
constexpr double k_fitted = 0.5;
constexpr std::size_t k_fewest_common = 3;
constexpr double k_half_cross = 3.0;
constexpr Color k_red = {255, 0, 0}, k_blue = {0, 60, 200};
constexpr std::array k_units = {Unit::mm, Unit::cm, Unit::dm, Unit::m, Unit::in};

std::vector<Vec2> border_of(const Patch& flat, double scale) {
  std::vector<Vec2> points;
  for (const std::vector<Index>& loop : flat.border_loops()) {
    for (const Index v : loop)
      points.push_back(scale * Vec2{flat.positions()[v].x, flat.positions()[v].y});
  }
  return points;
}

std::vector<Vec2> joined(std::span<const std::vector<Vec2>> lines) {
  std::vector<Vec2> points;
  for (const std::vector<Vec2>& line : lines)
    points.insert(points.end(), line.begin(), line.end());
  return points;
}

/// Where many of the vectors lie together, by squares of a fifth of k_near; their mean.
std::optional<Vec2> common_offset(std::span<const Vec2> offsets) {
  constexpr double cell = 0.2 * k_near;
  const auto cell_of = [](Vec2 v) {
    return std::pair(std::floor(v.x / cell), std::floor(v.y / cell));
  };
  std::map<std::pair<double, double>, std::size_t> counts;
  for (const Vec2 v : offsets)
    ++counts[cell_of(v)];
  std::pair<double, double> best;
  std::size_t most = 0;
  for (const auto& [at, count] : counts) {
    std::size_t around = 0;
    for (const double dx : {-1.0, 0.0, 1.0}) {
      for (const double dy : {-1.0, 0.0, 1.0}) {
        const auto found = counts.find({at.first + dx, at.second + dy});
        if (found != counts.end()) around += found->second;
      }
    }
    if (around <= most) continue;
    most = around;
    best = at;
  }
  if (most < k_fewest_common) return std::nullopt;
  Vec2 sum;
  std::size_t count = 0;
  for (const Vec2 v : offsets) {
    const auto [x, y] = cell_of(v);
    if (std::abs(x - best.first) > 1.0 || std::abs(y - best.second) > 1.0) continue;
    sum = sum + v;
    ++count;
  }
  return 1.0 / static_cast<double>(count) * sum;
}

/// From each vertex of the border to all points of the outline near it, by squares.
std::vector<Vec2> offsets_near(std::span<const Vec2> border, std::span<const Vec2> outline,
                               Vec2 origin) {
  using Cell = std::pair<double, double>;
  const auto cell_of = [](Vec2 p) {
    return Cell{std::floor(p.x / k_fitted), std::floor(p.y / k_fitted)};
  };
  std::map<Cell, std::vector<Vec2>> cells;
  for (const Vec2 p : outline)
    cells[cell_of(p)].push_back(p);
  std::vector<Vec2> offsets;
  for (const Vec2 p : border) {
    const Vec2 place = origin + p;
    const Cell own = cell_of(place);
    for (const double dx : {-1.0, 0.0, 1.0}) {
      for (const double dy : {-1.0, 0.0, 1.0}) {
        const auto found = cells.find({own.first + dx, own.second + dy});
        if (found == cells.end()) continue;
        for (const Vec2 q : found->second) {
          if (norm(q - place) <= k_fitted) offsets.push_back(q - place);
        }
      }
    }
  }
  return offsets;
}

/// The largest distance of some hundred vertices of the border from the outline.
double distance_from(std::span<const Vec2> border, std::span<const std::vector<Vec2>> outline,
                     Vec2 origin) {
  const std::size_t step = 1 + border.size() / 400;
  double most = 0.0;
  for (std::size_t i = 0; i < border.size(); i += step) {
    double least = std::numeric_limits<double>::infinity();
    for (const std::vector<Vec2>& line : outline) {
      for (std::size_t k = 0; k < line.size(); ++k) {
        const Vec2 a = line[k], b = line[(k + 1) % line.size()];
        least = std::min(least, distance_to_segment(origin + border[i], a, b));
      }
    }
    most = std::max(most, least);
  }
  return most;
}

bool are_close(double a, double b) {
  return std::abs(a - b) <= 1e-3 * b;
}

[[noreturn]] void fail(const std::string& name, const std::string& message) {
  throw Error(ErrorCode::malformed_file, message, {.path = name});
}

std::string size_text(Vec2 size) {
  return decimals_text(size.x, 2) + " x " + decimals_text(size.y, 2) + " mm";
}

[[noreturn]] void refuse(Vec2 drawn, Vec2 mesh, Unit unit, const std::string& name) {
  const std::string sizes =
      "the outline in layer seam or cut is not that of the flat mesh: it is " + size_text(drawn) +
      ", the border of the mesh " + size_text(mesh);
  const double ratio = drawn.x / mesh.x;
  if (!are_close(ratio * mesh.y, drawn.y) || are_close(ratio, 1.0)) {
    fail(name, sizes +
                   "; take the mesh of the pattern that was drawn on, and leave its layers seam "
                   "and cut as they are");
  }
  for (const Unit other : k_units) {
    if (are_close(ratio * millimetres_per(unit), millimetres_per(other)))
      fail(name, sizes + "; it fits with --unit " + std::string(to_string(other)));
  }
  fail(name, sizes + "; was the drawing scaled, or is --unit another one?");
}

}  // namespace

Vec2 origin_on_sheet(std::vector<std::vector<Vec2>> outline, std::span<const std::vector<Vec2>> cut,
                     const Patch& flat, Unit unit, const std::string& name) {
  if (outline.empty()) {
    fail(name,
         "the file has no outline of the pattern in a layer seam or cut, so that the place of "
         "what is drawn is not known; draw in a copy of pattern.svg");
  }
  const std::vector<Vec2> border = border_of(flat, millimetres_per(unit));
  if (border.empty()) fail(name, "the flat mesh has no border to find in the drawing");
  const LoopBox there = box_around(joined(outline)), here = box_around(border);
  outline.insert(outline.end(), cut.begin(), cut.end());
  const std::vector<Vec2> drawn = joined(outline);
  // A side of the box is that of the outline, or of a stretch that only the cut lines have.
  const Vec2 other = box_around(drawn).low;
  for (const Vec2 low :
       {there.low, Vec2{other.x, there.low.y}, Vec2{there.low.x, other.y}, other}) {
    const Vec2 origin = low - here.low;
    // Curves begin and end at vertices of the border, between which they leave it a little.
    const auto offset = common_offset(offsets_near(border, drawn, origin));
    if (offset && distance_from(border, outline, origin + *offset) <= k_fitted)
      return origin + *offset;
  }
  refuse(there.size(), here.size(), unit, name);
}

Drawing carried_sheet(const Patch& flat, const DrawnLines& drawn, Unit unit,
                      const std::string& title) {
  const double scale = millimetres_per(unit);
  const std::vector<Vec2> around = border_of(flat, scale);
  if (around.empty()) fail(title, "the flat mesh has no border, so it is no pattern");
  const LoopBox box = box_around(around);
  const Vec2 corner = {sheet::k_margin, sheet::k_margin + sheet::k_block_height + sheet::k_gap};
  const Vec2 origin = corner - box.low;
  const auto place = [&](Vec3 p) { return origin + scale * Vec2{p.x, p.y}; };
  Path border{{}, true, Stroke{k_red}};
  for (const std::vector<Index>& loop : flat.border_loops()) {
    std::vector<Vec2>& line = border.lines.emplace_back();
    for (const Index v : loop)
      line.push_back(place(flat.positions()[v]));
  }
  Layer carried{"carried", {}};
  for (const DrawnLine& some : drawn.lines) {
    std::vector<Vec2> line;
    line.reserve(some.points.size());
    for (const Vec3 p : some.points)
      line.push_back(place(p));
    carried.shapes.emplace_back(line_path(std::move(line), Stroke{k_blue}));
  }
  for (const Vec3 p : drawn.points) {
    const Vec2 q = place(p), right = {k_half_cross, 0.0}, up = {0.0, k_half_cross};
    carried.shapes.emplace_back(
        Path{{{q - right, q + right}, {q - up, q + up}}, false, Stroke{k_blue}});
  }
  const Vec2 high = origin + box.high;
  return {title,
          std::max(high.x, sheet::k_block_right) + sheet::k_margin,
          high.y + sheet::k_margin,
          {{"cut", {std::move(border)}}, std::move(carried)}};
}

}  // namespace planish
