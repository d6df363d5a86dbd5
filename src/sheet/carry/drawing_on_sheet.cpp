#include "sheet/carry/drawing_on_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <planish/core/error.h>

#include "core/figure_text.h"
#include "sheet/sheet_layout.h"

namespace planish {

namespace {

constexpr double k_near =
    0.02;  // millimetres: sheets have thousandths, other programs fewer digits
constexpr double k_half_cross = 3.0;
constexpr Color k_red = {255, 0, 0}, k_blue = {0, 60, 200};
constexpr std::array k_units = {Unit::mm, Unit::cm, Unit::dm, Unit::m, Unit::in};

struct PlaneBox {
  Vec2 low, high;

  Vec2 size() const { return high - low; }
};

PlaneBox box_of(std::span<const Vec2> points) {
  PlaneBox box{points.front(), points.front()};
  for (const Vec2 p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

std::vector<Vec2> border_of(const Patch& flat, double scale) {
  std::vector<Vec2> points;
  for (const std::vector<Index>& loop : flat.border_loops()) {
    for (const Index v : loop)
      points.push_back(scale * Vec2{flat.positions()[v].x, flat.positions()[v].y});
  }
  return points;
}

/// Finds a point near a place among points that are sorted by x.
std::optional<Vec2> nearest_of(std::span<const Vec2> sorted, Vec2 place) {
  const auto begin = std::lower_bound(sorted.begin(), sorted.end(), place.x - k_near,
                                      [](Vec2 p, double x) { return p.x < x; });
  std::optional<Vec2> nearest;
  for (auto p = begin; p != sorted.end() && p->x <= place.x + k_near; ++p) {
    const double apart = norm(*p - place);
    if (apart <= k_near && (!nearest || apart < norm(*nearest - place))) nearest = *p;
  }
  return nearest;
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

Vec2 origin_on_sheet(std::span<const std::vector<Vec2>> outline, const Patch& flat, Unit unit,
                     const std::string& name) {
  std::vector<Vec2> drawn;
  for (const std::vector<Vec2>& line : outline)
    drawn.insert(drawn.end(), line.begin(), line.end());
  if (drawn.empty()) {
    fail(name,
         "the file has no outline of the pattern in a layer seam or cut, so that the place of "
         "what is drawn is not known; draw in a copy of pattern.svg");
  }
  const std::vector<Vec2> border = border_of(flat, millimetres_per(unit));
  if (border.empty()) fail(name, "the flat mesh has no border to find in the drawing");
  const PlaneBox there = box_of(drawn), here = box_of(border);
  std::sort(drawn.begin(), drawn.end(),
            [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  const Vec2 origin = there.low - here.low;
  // The mean of all points is nearer than the least of them, which were rounded.
  Vec2 sum;
  for (const Vec2 p : border) {
    const auto found = nearest_of(drawn, origin + p);
    if (!found) refuse(there.size(), here.size(), unit, name);
    sum = sum + (*found - (origin + p));
  }
  return origin + 1.0 / static_cast<double>(border.size()) * sum;
}

Drawing carried_sheet(const Patch& flat, const DrawnLines& drawn, Unit unit,
                      const std::string& title) {
  const double scale = millimetres_per(unit);
  const PlaneBox box = box_of(border_of(flat, scale));
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
    Path line{{{}}, false, Stroke{k_blue}};
    for (const Vec3 p : some.points)
      line.lines.front().push_back(place(p));
    carried.shapes.emplace_back(std::move(line));
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
