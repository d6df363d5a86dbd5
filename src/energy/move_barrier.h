#pragma once

#include <vector>

#include <planish/core/vec.h>

#include "optimize/block.h"

namespace planish {

/// Slows moves that come near a limit of distance, so that steps need not be cut: with u the moves,
/// r the limits, n of how many vertices it is the mean,
///
///     sum of 0.3 / n (|u| / (0.85 r))^8
///
/// (docs/methods/smooth.md).
class MoveBarrier {
 public:
  /// @param reach r of each vertex, above 0; infinite where there is no limit
  /// @param counts n of each
  MoveBarrier(std::vector<double> reach, std::vector<double> counts);

  /// @param moves one of each vertex
  double value(const std::vector<Vec3>& moves) const;
  /// Of the vertex; zero where it has no limit or no move.
  struct Derivatives {
    Vec3 gradient;
    Block hessian;
  };
  /// @param stiff factor of the Hessian
  Derivatives derivatives(Index v, Vec3 move, double stiff = 1.0) const;
  /// True if a vertex is nearly as far as it may be.
  bool is_reached(const std::vector<Vec3>& moves) const;

 private:
  std::vector<double> reach_, weight_;
};

}  // namespace planish
