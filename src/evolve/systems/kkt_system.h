#pragma once

#include <vector>

#include "core/thread_pool.h"
#include "evolve/systems/angle_jacobian.h"
#include "evolve/systems/positions.h"
#include "solve/sparse_ldlt.h"

namespace planish {

/// The steps of methods that weigh more than lengths of moves, so that no n x n matrix will do:
///
///     [ H  A^T  ] [move]   [force]
///     [ A -mu D ] [ y  ] = [dtheta]
///
/// H an n x n matrix, the same for x, y and z, A the Jacobian of the angle sums, D the mean of the
/// squares of A's rows. Quasi-definite, four unknowns a vertex, factored under a dissection of the
/// mesh itself.
class KktSystem {
 public:
  /// @param hessian positive definite, lower half, on the edges of the patch; by inner vertex. Rows
  ///   of vertices that may not move do not matter.
  /// @param jacobian must outlive it
  KktSystem(const AngleJacobian& jacobian, const PatchState& state, const SparseMatrix& hessian);

  /// Factors for the gradients as they are; false where that cannot be.
  bool factor(double mu, ThreadPool& pool);

  /// @pre factor() was true
  Positions solve(const Positions& force, const Eigen::VectorXd& angle_change,
                  ThreadPool& pool) const;

 private:
  const AngleJacobian& jacobian_;
  SparseMatrix lower_;
  std::vector<std::size_t> gradient_entries_;  // x, y, z of each entry of the Jacobian, by column
  SparseLdlt solver_;
};

}  // namespace planish
