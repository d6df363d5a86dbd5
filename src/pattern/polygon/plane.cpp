#include "pattern/polygon/plane.h"

#include <algorithm>

#include "core/math.h"

namespace planish {

Vec2 direction_of(Vec2 v) {
  return 1.0 / norm(v) * v;
}

double turn_between(Vec2 a, Vec2 b) {
  return math::atan2(cross(a, b), dot(a, b));
}

Vec2 outwards(Vec2 direction) {
  return {direction.y, -direction.x};
}

double distance_to_segment(Vec2 p, Vec2 a, Vec2 b) {
  const Vec2 way = b - a;
  const double square = dot(way, way);
  const double share = square > 0.0 ? std::clamp(dot(p - a, way) / square, 0.0, 1.0) : 0.0;
  return norm(p - (a + share * way));
}

bool are_opposite(Vec2 unit, Vec2 other) {
  return dot(unit, other) <= -0.5 * norm(other);
}

Vec2 direction(Vec2 from, Vec2 to) {
  const double length = norm(to - from);
  return length > 0.0 ? 1.0 / length * (to - from) : Vec2{};
}

}  // namespace planish
