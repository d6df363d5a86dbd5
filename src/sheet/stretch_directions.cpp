#include "sheet/stretch_directions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "core/math.h"

namespace planish {

namespace {

constexpr double k_covered = 1.0 / 3.0;  // of a cell, at least
constexpr double k_shown = 0.05;         // of the limit, at least

/// A symmetric matrix ((xx, xy), (xy, yy)).
struct Tensor {
  double xx = 0.0, xy = 0.0, yy = 0.0;
};

struct Cell {
  Tensor sum;
  Vec2 place;
  double area = 0.0;
};

/// F F^T of one triangle; nothing of use where the patch has no area.
Tensor squared_stretch(Vec3 a, Vec3 b, Vec2 flat_a, Vec2 flat_b) {
  const double length = norm(a), height = norm(cross(a, b)) / length;
  const double along = dot(a, b) / length;
  const Vec2 p = (1.0 / length) * flat_a;
  const Vec2 q = (1.0 / height) * (flat_b - along * p);
  return {p.x * p.x + q.x * q.x, p.x * p.y + q.x * q.y, p.y * p.y + q.y * q.y};
}

StretchDirection direction_of(const Cell& cell) {
  const double share = 1.0 / cell.area;
  const Tensor mean = {share * cell.sum.xx, share * cell.sum.xy, share * cell.sum.yy};
  const double middle = 0.5 * (mean.xx + mean.yy);
  const double radius = math::hypot(0.5 * (mean.xx - mean.yy), mean.xy);
  const double longer = std::sqrt(middle + radius) - 1.0;
  const double shorter = std::sqrt(std::max(0.0, middle - radius)) - 1.0;
  const double angle = 0.5 * math::atan2(2.0 * mean.xy, mean.xx - mean.yy);
  const Vec2 first = {math::cos(angle), math::sin(angle)};
  const Vec2 place = share * cell.place;
  if (std::abs(longer) >= std::abs(shorter)) return {place, first, longer};
  return {place, {-first.y, first.x}, shorter};
}

double area_of(const TriMesh& mesh, std::span<const Vec2> pattern) {
  double area = 0.0;
  for (const Triangle& t : mesh.triangles)
    area += 0.5 * std::abs(cross(pattern[t[1]] - pattern[t[0]], pattern[t[2]] - pattern[t[0]]));
  return area;
}

}  // namespace

std::vector<StretchDirection> stretch_directions(const TriMesh& mesh, std::span<const Vec2> pattern,
                                                 int count) {
  const double size = std::sqrt(area_of(mesh, pattern) / count);
  if (!(size > 0.0) || !std::isfinite(size)) return {};
  std::map<std::pair<double, double>, Cell> cells;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 x = mesh.positions[t[0]];
    const Vec2 flat = pattern[t[0]], a = pattern[t[1]] - flat, b = pattern[t[2]] - flat;
    const Tensor tensor = squared_stretch(mesh.positions[t[1]] - x, mesh.positions[t[2]] - x, a, b);
    const double area = 0.5 * std::abs(cross(a, b));
    if (!std::isfinite(tensor.xx + tensor.xy + tensor.yy) || !(area > 0.0)) continue;
    const Vec2 middle = flat + (1.0 / 3.0) * (a + b);
    Cell& cell = cells[{std::floor(middle.x / size), std::floor(middle.y / size)}];
    cell.sum.xx += area * tensor.xx;
    cell.sum.xy += area * tensor.xy;
    cell.sum.yy += area * tensor.yy;
    cell.place = cell.place + area * middle;
    cell.area += area;
  }
  std::vector<StretchDirection> places;
  for (const auto& [number, cell] : cells) {
    if (cell.area >= k_covered * size * size) places.push_back(direction_of(cell));
  }
  return places;
}

Layer direction_layer(std::span<const StretchDirection> places, double limit, double length) {
  Path path;
  for (const StretchDirection& place : places) {
    const double share = std::min(1.0, std::abs(place.strain) / limit);
    if (!(share >= k_shown)) continue;
    const Vec2 half = (0.5 * length * share) * place.along;
    const double head = 0.16 * length * std::sqrt(share);
    const Vec2 back = (place.strain > 0.0 ? -head : head) * place.along;
    const Vec2 side = (0.6 * head) * Vec2{-place.along.y, place.along.x};
    path.lines.push_back({place.at - half, place.at + half});
    for (const double sign : {-1.0, 1.0}) {
      // The tip is at the end of the line either way, so that its length stays readable.
      const Vec2 end = place.at + sign * half;
      const Vec2 tip = place.strain > 0.0 ? end : end - sign * back;
      const Vec2 foot = tip + sign * back;
      path.lines.push_back({foot + side, tip, foot - side});
    }
  }
  path.stroke = Stroke{};
  if (path.lines.empty()) return {"directions", {}};
  return {"directions", {std::move(path)}};
}

}  // namespace planish
