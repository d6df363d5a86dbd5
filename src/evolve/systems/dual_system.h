#pragma once

#include <cstdint>
#include <vector>

#include "core/thread_pool.h"
#include "energy/angle_jacobian.h"
#include "evolve/state/patch_state.h"
#include "evolve/systems/dense.h"
#include "solve/graph.h"
#include "solve/mixed_ldlt.h"

namespace planish {

/// The n x n system (A S A^T + mu D) y = b of all methods that seek the least change of positions
/// that turns the angle sums as asked: A the Jacobian of the angle sums, S a factor per vertex, D
/// the median of the diagonal of A S A^T, so that mu has no unit. A S A^T couples vertices two
/// edges apart; the same step by the 3n x 3n matrix of the positions costs 20 times as much.
class DualSystem {
 public:
  /// @param jacobian must outlive it
  DualSystem(const AngleJacobian& jacobian, const PatchState& state,
             Precision precision = Precision::full);

  /// What D is to be from now on, instead of the identity times that median: a symmetric matrix,
  /// scaled so that the median of its diagonal is the same, and a share of the identity. Entries
  /// between rows that do not meet go to the diagonal.
  void damp_by(const SparseMatrix& symmetric, double share_of_identity);

  /// Factors for the gradients as they are.
  /// @param inverse_weights S = W^-2, by column of the Jacobian: its inner vertices
  /// @return false where the matrix cannot be factored
  bool factor(std::span<const double> inverse_weights, double mu, ThreadPool& pool);

  /// The same with a diagonal of its own to add, by row.
  bool factor_with(std::span<const double> inverse_weights, std::span<const double> damping,
                   ThreadPool& pool);

  /// @pre factor() was true
  Eigen::VectorXd solve(const Eigen::VectorXd& right, ThreadPool& pool) {
    return solver_.solve(lower_, right, pool, k_step_accuracy);
  }
  /// Whether float did not do for the last matrix.
  bool fell_back() const { return solver_.fell_back(); }

 private:
  DualSystem(const AngleJacobian& jacobian, const PatchState& state, const Graph& rows,
             Precision precision);
  void assemble(std::span<const double> inverse_weights);

  const AngleJacobian& jacobian_;
  SparseMatrix lower_;
  std::vector<double> damping_;  // D over the median, for the entries of lower_; none: identity
  std::vector<std::uint32_t> products_;  // for each pair of rows that a vertex is in: its place
  MixedLdlt solver_;
};

}  // namespace planish
