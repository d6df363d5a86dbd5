#pragma once

#include <cmath>
#include <cstddef>

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

/// The sum of the angles at p of the triangles that it makes with its open ring.
/// @param at the position of a vertex of the ring
template <class Ring, class At>
double open_angle_sum(Vec3 p, const Ring& ring, const At& at) {
  double sum = 0.0;
  for (std::size_t j = 0; j + 1 < ring.size(); ++j)
    sum += angle_between(at(ring[j]) - p, at(ring[j + 1]) - p);
  return sum;
}

}  // namespace planish
