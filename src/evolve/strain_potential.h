#pragma once

#include <optional>

#include "core/thread_pool.h"
#include "evolve/angle_jacobian.h"
#include "solve/sparse_ldlt.h"

namespace planish {

/// phi with K phi = d, phi = 0 at the border: K the stiffness matrix of cotangents, d the angle
/// defects. To first order e^phi is by how much the best conformal pattern stretches (Ben-Chen and
/// others 2008), so unlike the energy it does not depend on the density of the mesh.
class StrainPotential {
 public:
  /// Takes K from the patch as it is: positive definite, as of finite elements, where each part of
  /// the patch has a border.
  StrainPotential(const AngleJacobian& jacobian, const PatchState& state, ThreadPool& pool);

  /// False where K cannot be factored.
  bool solvable() const { return solvable_; }
  /// @param defects by inner vertex, radians
  Eigen::VectorXd of(const Eigen::VectorXd& defects, ThreadPool& pool) const {
    return solver_->solve(defects, pool);
  }
  /// K, both halves.
  const SparseMatrix& stiffness() const { return stiffness_; }

 private:
  SparseMatrix stiffness_;
  std::optional<SparseLdlt> solver_;
  bool solvable_ = false;
};

}  // namespace planish
