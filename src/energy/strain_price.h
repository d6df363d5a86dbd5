#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/neumaier_sum.h"
#include "energy/flat_edge.h"

namespace planish {

/// What a strain costs, with its derivatives.
struct Price {
  double value, slope, curvature;
};

/// Where the rms is to fall: x^2.
inline Price square_price(double x) {
  return {x * x, 2.0 * x, 2.0};
}

/// Where peaks are to fall: x^8 of the strain over the peak strain, continued above 1 by its
/// parabola, so that a few edges with far more strain do not dominate.
inline Price peak_price(double x) {
  const double size = std::abs(x);
  if (size >= 1.0) {
    const double beyond = size - 1.0;
    return {1.0 + beyond * (8.0 + 28.0 * beyond), std::copysign(8.0 + 56.0 * beyond, x), 56.0};
  }
  const double square = x * x, sixth = square * square * square;
  return {sixth * square, 8.0 * sixth * x, 56.0 * sixth};
}

/// The sum over edges of a price(q / p), a their areas, q their strains, p a strain
/// (docs/unfold.md, "Spreading the stretch").
struct StrainPrice {
  std::span<const FlatEdge> edges;
  double unit;  ///< p
  Price (&price_of)(double);

  double value(const std::vector<Vec2>& flat) const {
    NeumaierSum sum;
    for (const FlatEdge& edge : edges)
      sum.add(edge.area * price_of(LaidEdge(edge, flat).strain / unit).value);
    return sum.value();
  }
  /// Derivatives of the price of one edge, multiplied by `factor`.
  EdgeTerm term(const FlatEdge& edge, const std::vector<Vec2>& flat, double factor = 1.0) const {
    const LaidEdge laid(edge, flat);
    const Price price = price_of(laid.strain / unit);
    const double rest = unit * edge.length, slope = factor * edge.area * price.slope / rest;
    return laid.term(slope, factor * edge.area * price.curvature / (rest * rest),
                     std::max(0.0, slope) / laid.length);
  }
};

}  // namespace planish
