#pragma once

#include <array>
#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// One side of a triangle and the triangle beyond it.
struct TriangleHinge {
  static constexpr Index none = static_cast<Index>(-1);

  Index other = none;   ///< the triangle beyond; none on the border
  double angle = 0.0;   ///< as of Bend; 0 on the border
  double length = 0.0;  ///< of the side, times Patch::unit_scale()

  bool is_border() const { return other == none; }
};

/// Side k goes from corner k to the next.
using TriangleHinges = std::array<TriangleHinge, 3>;

/// Of each triangle. O(n).
std::vector<TriangleHinges> triangle_hinges(const Patch& patch);

/// Of each triangle, times the square of Patch::unit_scale(). O(n).
std::vector<double> triangle_areas(const Patch& patch);

}  // namespace planish
