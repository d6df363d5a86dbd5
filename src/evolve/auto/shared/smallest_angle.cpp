#include "evolve/auto/shared/smallest_angle.h"

#include <algorithm>
#include <limits>
#include <mutex>

#include "geometry/smallest_angle.h"

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
  return smallest_angle(state.position(t[0]), state.position(t[1]), state.position(t[2]));
}

}  // namespace planish
