#include "evolve/smallest_angle.h"

#include <algorithm>
#include <limits>
#include <mutex>

#include "core/angle_between.h"

namespace planish {

double smallest_angle(const PatchState& state, std::span<const Triangle> triangles,
                      ThreadPool& pool) {
  double least = std::numeric_limits<double>::infinity();
  std::mutex mutex;
  pool.for_ranges(triangles.size(), 4096, [&](std::size_t begin, std::size_t end) {
    double own = std::numeric_limits<double>::infinity();
    for (std::size_t t = begin; t < end; ++t)
      own = std::min(own, smallest_angle(state, triangles[t]));
    const std::lock_guard lock(mutex);
    least = std::min(least, own);
  });
  return least;
}

double smallest_angle(const PatchState& state, const Triangle& t) {
  const Vec3 p = state.position(t[0]), q = state.position(t[1]), r = state.position(t[2]);
  const double a = dot(r - q, r - q), b = dot(p - r, p - r), c = dot(q - p, q - p);
  if (a <= b && a <= c) return angle_between(q - p, r - p);
  return b <= c ? angle_between(r - q, p - q) : angle_between(p - r, q - r);
}

}  // namespace planish
