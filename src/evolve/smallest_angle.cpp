#include "evolve/smallest_angle.h"

#include <algorithm>
#include <limits>

#include "core/angle_between.h"

namespace planish {

double smallest_angle(const PatchState& state) {
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& t : state.triangles())
    least = std::min(least, smallest_angle(state, t));
  return least;
}

double smallest_angle(const PatchState& state, const Triangle& t) {
  const Vec3 p = state.position(t[0]), q = state.position(t[1]), r = state.position(t[2]);
  return std::min(
      {angle_between(q - p, r - p), angle_between(r - q, p - q), angle_between(p - r, q - r)});
}

}  // namespace planish
