#pragma once

#include <planish/core/vec.h>

namespace planish {

/// How the angle of a triangle at p changes with the positions of its corners, in radians per unit
/// of length.
struct AngleGradient {
  Vec3 at_p, at_q, at_r;
};

/// Gradient of the angle at p of the triangle p, q, r, whatever its orientation. With a = q - p,
/// b = r - p and the unit normal n of a x b: (a x n)/|a|^2 at q, -(b x n)/|b|^2 at r and minus
/// their sum at p. So it is exact for needles too, where forms with cotangents divide by nothing.
/// An angle of exactly 0 or pi, where there is no derivative, counts as one that stays: all 0.
inline AngleGradient angle_gradient(Vec3 p, Vec3 q, Vec3 r) {
  const Vec3 a = q - p, b = r - p, c = cross(a, b);
  const double area = norm(c);
  if (!(area > 0.0)) return {};
  const Vec3 n = (1.0 / area) * c;
  const Vec3 at_q = (1.0 / dot(a, a)) * cross(a, n);
  const Vec3 at_r = (1.0 / dot(b, b)) * cross(n, b);
  return {-(at_q + at_r), at_q, at_r};
}

}  // namespace planish
