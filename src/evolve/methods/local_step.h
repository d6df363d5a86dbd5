#pragma once

#include <Eigen/Core>

namespace planish {

/// The step of a few vertices that is nearest to where they are pulled, among those that meet
/// linear conditions:
///
///   minimise 1/2 sum_i weights_i^2 (step_i - pull_i)^2   over the coordinates i
///   subject to  rows step  = sides    for the first `equations` rows,
///               rows step >= sides    for those below.
///
/// Rows should be about equally large.
struct LocalStep {
  Eigen::MatrixXd rows;
  Eigen::VectorXd sides;
  Eigen::Index equations = 0;
  Eigen::VectorXd pull;
  Eigen::VectorXd weights;  ///< above 0

  /// Where conditions contradict each other, which whole regions of angle sums do (moving vertices
  /// conserves their total), they are met as well as can be in least squares. Inequalities come in
  /// and leave as an active set does; where that finds no end, after some twenty tries, the last
  /// one is returned and may break some.
  /// @param rank_threshold eigenvalues of rows W^-2 rows^T below this share of the largest count as
  ///   0, and what they stand for is left out
  Eigen::VectorXd solve(double rank_threshold) const;
};

}  // namespace planish
