#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// The largest distance of two vertices of the same number.
inline double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double distance = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v)
    distance = std::max(distance, norm(a[v] - b[v]));
  return distance;
}

}  // namespace planish
