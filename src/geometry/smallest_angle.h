#pragma once

#include <planish/core/vec.h>

#include "geometry/angle_between.h"

namespace planish {

/// The smallest angle of a triangle, radians: it lies opposite the shortest side. 0 where the
/// triangle has no area.
inline double smallest_angle(Vec3 p, Vec3 q, Vec3 r) {
  const double a = dot(r - q, r - q), b = dot(p - r, p - r), c = dot(q - p, q - p);
  if (a <= b && a <= c) return angle_between(q - p, r - p);
  return b <= c ? angle_between(r - q, p - q) : angle_between(p - r, q - r);
}

}  // namespace planish
