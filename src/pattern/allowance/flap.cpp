#include "pattern/allowance/flap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pattern/polygon/winding_union.h"

namespace planish {

Vec2 CreaseLine::mirrored(Vec2 p) const {
  const Vec2 left = {-along.y, along.x};
  return p - 2.0 * height(p) * left;
}

Polygon mirrored(Polygon polygon, const CreaseLine& crease) {
  for (Vec2& p : polygon)
    p = crease.mirrored(p);
  std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

Polygon strip_over(const CreaseLine& crease, const Polygon& flap) {
  constexpr double k_near = 1e-4, k_half = 0.001;  // millimetres
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Vec2 p : flap) {
    if (std::abs(crease.height(p)) > k_near) continue;
    const double way = dot(crease.along, p - crease.at);
    low = std::min(low, way);
    high = std::max(high, way);
  }
  if (!(low < high)) return {};
  const Vec2 a = crease.at + low * crease.along, b = crease.at + high * crease.along;
  const Vec2 left = k_half * Vec2{-crease.along.y, crease.along.x};
  return {a - left, b - left, b + left, a + left};
}

void straighten(std::size_t from, std::size_t to, Polygon& loop) {
  const Vec2 start = loop[from], way = loop[to] - start;
  const double squared = dot(way, way);
  if (!(squared > 0.0)) return;
  for (std::size_t i = (from + 1) % loop.size(); i != to; i = (i + 1) % loop.size())
    loop[i] = start + dot(loop[i] - start, way) / squared * way;
}

std::vector<Polygon> united_flaps(const std::vector<Polygon>& lines) {
  constexpr double k_speck = 1e-6;  // square millimetres
  std::vector<Polygon> united = winding_union(lines);
  std::erase_if(united, [](const Polygon& line) { return std::abs(signed_area(line)) < k_speck; });
  return united;
}

}  // namespace planish
