#include "pattern/polygon/polygon_rays.h"

#include <algorithm>
#include <cstddef>

namespace planish {

double first_hit(std::span<const Polygon> loops, Vec2 place, Vec2 direction, double from) {
  double first = k_no_hit;
  for (const Polygon& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = loop[i] - place, b = loop[(i + 1) % loop.size()] - place;
      const double left = cross(direction, a), right = cross(direction, b);
      if ((left >= 0.0) == (right >= 0.0)) continue;
      const Vec2 hit = a + left / (left - right) * (b - a);
      const double distance = dot(hit, direction);
      if (distance >= from) first = std::min(first, distance);
    }
  }
  return first;
}

bool is_within(std::span<const Polygon> loops, Vec2 place) {
  bool within = false;
  for (const Polygon& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 a = loop[i], b = loop[(i + 1) % loop.size()];
      if ((a.y > place.y) == (b.y > place.y)) continue;
      if (place.x < a.x + (place.y - a.y) / (b.y - a.y) * (b.x - a.x)) within = !within;
    }
  }
  return within;
}

}  // namespace planish
