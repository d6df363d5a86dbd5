#include "evolve/smallest_angle.h"

#include <algorithm>
#include <limits>

#include "core/angle_between.h"

namespace planish {

double smallest_angle(const PatchState& state) {
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& t : state.triangles()) {
    const Vec3 p = state.position(t[0]), q = state.position(t[1]), r = state.position(t[2]);
    least = std::min({least, angle_between(q - p, r - p), angle_between(r - q, p - q),
                      angle_between(p - r, q - r)});
  }
  return least;
}

}  // namespace planish
