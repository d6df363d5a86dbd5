#pragma once

#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "energy/strain_potential.h"
#include "evolve/systems/positions.h"
#include "support/moves.h"

namespace planish {

/// |phi|^2 = d (K K^T)^-1 d; by positions d changes by minus the Jacobian of the angle sums.
/// @param laid has a state, its jacobian, a pool, and defects() of the state as it is now
template <class Laid>
void expect_gradient_of_strain(Laid& laid, StrainPotential& potential) {
  const Eigen::MatrixXd lower(potential.square()), matrix = lower.selfadjointView<Eigen::Lower>();
  EXPECT_GT(matrix.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff(), 0.0);
  const Positions x = first_positions(laid.state, laid.jacobian.column_count());
  const Positions gradient =
      laid.jacobian.transposed_times(-2.0 * matrix.ldlt().solve(laid.defects()), laid.pool);
  const Positions u = some_moves(x.size(), 1e-5 * laid.state.scale());
  const auto value_at = [&](double share) {
    set_positions(sum_of(x, share, u), laid.jacobian, laid.state);
    return potential.of(laid.defects(), laid.pool).squaredNorm();
  };
  const double slope = 0.5 * (value_at(1.0) - value_at(-1.0));
  EXPECT_NEAR(product(gradient, u), slope, 1e-4 * std::abs(slope));
}

}  // namespace planish
