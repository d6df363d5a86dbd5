#include "geometry/cotangents.h"

#include <algorithm>
#include <cstddef>

namespace planish {

double cotangent(Vec3 a, Vec3 b) {
  constexpr double least_sine = 1e-3;
  const double sine = std::max(norm(cross(a, b)), least_sine * norm(a) * norm(b));
  return sine > 0.0 ? dot(a, b) / sine : 0.0;
}

std::vector<double> cotangent_weights(Vec3 p, std::span<const Vec3> ring, RingEnds ends) {
  std::vector<double> weights(ring.size(), 0.0);
  const std::size_t count = ends == RingEnds::open ? ring.size() - 1 : ring.size();
  for (std::size_t j = 0; j < count; ++j) {
    const std::size_t k = j + 1 < ring.size() ? j + 1 : 0;
    const Vec3 q = ring[j], r = ring[k];
    weights[j] += 0.5 * cotangent(p - r, q - r);
    weights[k] += 0.5 * cotangent(p - q, r - q);
  }
  return weights;
}

double mixed_area(Vec3 p, std::span<const Vec3> ring) {
  double area = 0.0;
  for (std::size_t j = 0; j < ring.size(); ++j) {
    const Vec3 a = ring[j] - p, b = ring[j + 1 < ring.size() ? j + 1 : 0] - p;
    const double triangle = 0.5 * norm(cross(a, b));
    if (dot(a, b) < 0.0) {
      area += 0.5 * triangle;
    } else if (dot(a, a - b) < 0.0 || dot(b, b - a) < 0.0) {
      area += 0.25 * triangle;
    } else {
      area += 0.125 * (dot(b, b) * cotangent(a, a - b) + dot(a, a) * cotangent(b, b - a));
    }
  }
  return area;
}

}  // namespace planish
