#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <planish/pattern/curve.h>

namespace planish {

/// Directions of length 1 that a curve has at its ends, where they are known.
struct EndDirections {
  std::optional<Vec2> first, last;
};

/// A cubic along a line, from its first point to its last.
struct FittedCubic {
  CubicTo cubic;
  double distance = 0.0;  ///< the largest between curve and line, in both directions
  std::size_t worst = 0;  ///< the point of the line that is nearest to where that is
};

/// Fits a cubic to points by least squares, with parameters that are improved until each point's is
/// that of its foot on the curve.
/// @param points at least three, no two neighbours at one place
/// @param tolerance good enough: no more steps are made
FittedCubic fit_cubic(std::span<const Vec2> points, const EndDirections& ends, double tolerance);

}  // namespace planish
