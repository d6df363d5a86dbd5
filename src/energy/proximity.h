#pragma once

#include <utility>
#include <vector>

#include <planish/core/vec.h>

#include "core/neumaier_sum.h"

namespace planish {

/// Keeps vertices near to where they were,
///
///     sum of w |u|^2 / (n l^2),
///
/// u their moves, w their weights, n how many there are: moves of length l cost 1
/// (docs/methods/smooth.md).
class Proximity {
 public:
  explicit Proximity(std::vector<double> weights) : weights_(std::move(weights)) {}

  /// @param length l
  double value(const std::vector<Vec3>& moves, double length) const {
    NeumaierSum sum;
    for (std::size_t v = 0; v < moves.size(); ++v)
      sum.add(weights_[v] * dot(moves[v], moves[v]));
    return of_square(length) * sum.value();
  }
  /// k at a vertex: the gradient is k u, the Hessian k times the identity.
  double stiffness(Index v, double length) const { return 2.0 * of_square(length) * weights_[v]; }

 private:
  double of_square(double length) const {
    return 1.0 / (static_cast<double>(weights_.size()) * length * length);
  }

  std::vector<double> weights_;
};

}  // namespace planish
