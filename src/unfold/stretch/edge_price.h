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

/// Where peaks are to fall, of x times the usual peak: x^8, and from 1 on the parabola that goes on
/// from there, so that the few edges with much more do not decide for all.
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
