#include "unfold/stretch/flat_steps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace planish {

std::vector<Vec2> turn_to_axis(const Disk& disk, std::vector<Vec2> flat) {
  const Vec2 origin = flat[disk.border.front()];
  const Vec2 to = flat[opposite_of_first(disk)] - origin;
  const double distance = norm(to);
  const Vec2 axis = distance > 0.0 ? (1.0 / distance) * to : Vec2{1.0, 0.0};
  for (Vec2& p : flat)
    p = {dot(axis, p - origin), cross(axis, p - origin)};
  return flat;
}

double step_to_first_flip(const Disk& disk, const std::vector<Vec2>& flat,
                          const std::vector<Vec2>& step) {
  double first = std::numeric_limits<double>::infinity();
  for (const Triangle& t : disk.triangles) {
    const Vec2 a = flat[t[1]] - flat[t[0]], b = flat[t[2]] - flat[t[0]];
    const Vec2 da = step[t[1]] - step[t[0]], db = step[t[2]] - step[t[0]];
    // Area along the step: c + b1 s + a2 s^2, c > 0; its smallest positive root.
    const double a2 = cross(da, db), b1 = cross(a, db) + cross(da, b), c = cross(a, b);
    const double root = b1 * b1 - 4.0 * a2 * c;
    if (root < 0.0) continue;
    const double q = -0.5 * (b1 + std::copysign(std::sqrt(root), b1));
    for (const double s : {a2 != 0.0 ? q / a2 : -1.0, q != 0.0 ? c / q : -1.0}) {
      if (s > 0.0) first = std::min(first, s);
    }
  }
  return first;
}

std::vector<Vec2> moved(std::vector<Vec2> flat, double share, const std::vector<Vec2>& step) {
  for (std::size_t v = 0; v < flat.size(); ++v)
    flat[v] = flat[v] + share * step[v];
  return flat;
}

}  // namespace planish
