#pragma once

#include <cmath>

#include "evolve/systems/positions.h"

namespace planish {

/// Moves of so many vertices, no two alike.
inline Positions some_moves(std::size_t count, double size) {
  Positions moves(count);
  for (std::size_t v = 0; v < count; ++v) {
    const auto t = static_cast<double>(v);
    moves[v] = size * Vec3{std::sin(1.3 * t), std::cos(2.1 * t), std::sin(0.7 * t + 1.0)};
  }
  return moves;
}

inline double product(const Positions& a, const Positions& b) {
  double sum = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v)
    sum += dot(a[v], b[v]);
  return sum;
}

}  // namespace planish
