#pragma once

#include <cmath>

#include <planish/core/vec.h>

#include "core/math.h"

namespace planish {

/// Angle between two vectors, radians in [0, pi], as exact for small angles as for large ones;
/// 0 where one of them is 0.
inline double angle_between(Vec3 a, Vec3 b) {
  return math::atan2(norm(cross(a, b)), dot(a, b));
}

/// The same in the plane.
inline double angle_between(Vec2 a, Vec2 b) {
  return math::atan2(std::abs(cross(a, b)), dot(a, b));
}

}  // namespace planish
