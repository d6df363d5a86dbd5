#pragma once

#include <planish/core/vec.h>

namespace planish {

/// Twice the area over the sum of the squared edges: 0 of a needle or a point, 1 / sqrt 12 at most.
inline double triangle_shape(Vec3 p, Vec3 q, Vec3 r) {
  const Vec3 a = q - p, b = r - p, c = r - q;
  return norm(cross(a, b)) / (dot(a, a) + dot(b, b) + dot(c, c));
}

/// No step may bring a triangle's shape below this: it would have no angles to speak of.
inline constexpr double k_least_shape = 1e-9;

}  // namespace planish
