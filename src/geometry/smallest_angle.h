#pragma once

#include <utility>

#include <planish/core/vec.h>

#include "geometry/angle_between.h"

namespace planish {

/// The sides of a triangle that meet at its smallest angle, which lies opposite the shortest side.
inline std::pair<Vec3, Vec3> sides_of_smallest_angle(Vec3 p, Vec3 q, Vec3 r) {
  const double a = dot(r - q, r - q), b = dot(p - r, p - r), c = dot(q - p, q - p);
  if (a <= b && a <= c) return {q - p, r - p};
  return b <= c ? std::pair{r - q, p - q} : std::pair{p - r, q - r};
}

/// The smallest angle of a triangle, radians. 0 where the triangle has no area.
inline double smallest_angle(Vec3 p, Vec3 q, Vec3 r) {
  const auto [u, w] = sides_of_smallest_angle(p, q, r);
  return angle_between(u, w);
}

/// Whether smallest_angle() is at least an angle: takes an arctangent only where it is close.
/// @param cosine of the angle
inline bool has_smallest_angle_from(double angle, double cosine, Vec3 p, Vec3 q, Vec3 r) {
  constexpr double margin = 1e-9;  // far above rounding
  const auto [u, w] = sides_of_smallest_angle(p, q, r);
  const double along = dot(u, w), bound = cosine - margin;
  const bool surely =
      along > 0.0 && bound > 0.0 && along * along < bound * bound * (dot(u, u) * dot(w, w));
  return surely || angle_between(u, w) >= angle;
}

}  // namespace planish
