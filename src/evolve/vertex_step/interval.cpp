#include "evolve/vertex_step/interval.h"

#include <algorithm>
#include <cmath>

namespace planish {

Interval within_sphere(Interval steps, Vec3 x, Vec3 direction, Vec3 origin, double radius) {
  if (!std::isfinite(radius)) return steps;
  // A hair inside, so that rounding cannot carry a vertex out: |x + t L - o|^2 = r^2.
  const double r = radius * (1.0 - 1e-12);
  const Vec3 offset = x - origin;
  const double a = dot(direction, direction), b = dot(offset, direction);
  const double c = dot(offset, offset) - r * r;
  const double root = b * b - a * c;
  if (!(root > 0.0) || a == 0.0) return {};
  // The root of larger size first, the other from it, without cancellation.
  const double q = -(b + std::copysign(std::sqrt(root), b));
  const double t1 = q / a, t2 = q != 0.0 ? c / q : 0.0;
  return {std::clamp(std::min(t1, t2), steps.low, 0.0),
          std::clamp(std::max(t1, t2), 0.0, steps.high)};
}

}  // namespace planish
