#pragma once

#include <cmath>

namespace planish {

/// What a strain costs, with its derivatives.
struct EdgePrice {
  double value, slope, curvature;
};

/// Where the rms is to fall.
inline EdgePrice square_price(double x) {
  return {x * x, 2.0 * x, 2.0};
}

/// Where peaks are to fall: x^8 of the strain over the peak strain, continued above 1 by its
/// parabola, so that a few edges with far more strain do not dominate.
inline EdgePrice price_of(double x) {
  const double size = std::abs(x);
  if (size >= 1.0) {
    const double beyond = size - 1.0;
    return {1.0 + beyond * (8.0 + 28.0 * beyond), std::copysign(8.0 + 56.0 * beyond, x), 56.0};
  }
  const double square = x * x, sixth = square * square * square;
  return {sixth * square, 8.0 * sixth * x, 56.0 * sixth};
}

}  // namespace planish
