#pragma once

#include <cstddef>

#include <planish/core/vec.h>

namespace planish {

/// L(v) with the paper's edge-length weights (Eq. 9), for v at x with `count` neighbours.
/// @param position_of neighbour number -> Vec3
template <class PositionOf>
Vec3 edge_weighted_laplacian(Vec3 x, std::size_t count, const PositionOf& position_of) {
  Vec3 sum;
  double weights = 0.0;
  for (std::size_t j = 0; j < count; ++j) {
    const Vec3 u = position_of(j) - x;
    const double weight = norm(u);
    sum += weight * u;
    weights += weight;
  }
  return weights > 0.0 ? (1.0 / weights) * sum : Vec3{};
}

}  // namespace planish
