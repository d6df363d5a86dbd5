#pragma once

#include <algorithm>
#include <complex>
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

/// Positions in the plane about their mean, so that two patterns differ by a rotation alone.
inline std::vector<std::complex<double>> centred(const std::vector<Vec2>& positions) {
  std::vector<std::complex<double>> result;
  std::complex<double> sum;
  for (const Vec2 p : positions) {
    result.emplace_back(p.x, p.y);
    sum += result.back();
  }
  for (auto& position : result)
    position -= sum / static_cast<double>(result.size());
  return result;
}

}  // namespace planish
