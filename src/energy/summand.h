#pragma once

#include <array>
#include <cstddef>

#include <planish/core/vec.h>

namespace planish {

/// A part of an energy, at a stencil of vertices: a function f of a length or an angle that
/// depends on their positions.
template <std::size_t n, class Vec = Vec3>
struct Summand {
  std::array<Index, n> vertices;
  double first = 0.0;                ///< f'
  double second = 0.0;               ///< f'', at least 0: that of Gauss and Newton
  std::array<Vec, n> gradient = {};  ///< of the length or angle, by each vertex
};

}  // namespace planish
