#pragma once

#include <span>
#include <vector>

#include "evolve/angle_jacobian.h"
#include "solve/sparse_ldlt.h"

namespace planish {

/// The steps of vertices along their normals n_v that a cost of shape allows and that bring strain
/// down: of the step s and the multipliers y
///
///     [ stiffness H_n     J^T        ] [s]   [force]
///     [ J              -sigma^2 K K^T ] [y] = [turn ]
///
/// H_n the cost's n x n matrix, its entries times n_v . n_w; J = d d / d s the defects' Jacobian
/// along the normals; K the matrix of StrainPotential. Quasi-definite, two unknowns a vertex. Moves
/// along the surface would double the unknowns and hardly change its form.
class NormalSystem {
 public:
  /// @param cost,square both halves, by inner vertex; their patterns stay
  /// @param jacobian must outlive it
  NormalSystem(const AngleJacobian& jacobian, const PatchState& state, const SparseMatrix& cost,
               const SparseMatrix& square);

  /// Factors for the gradients as they are; false where that cannot be.
  /// @param normals unit, by inner vertex
  /// @param unit of length of steps
  bool factor(std::span<const Vec3> normals, const SparseMatrix& cost, const SparseMatrix& square,
              double unit, double stiffness, double sigma, ThreadPool& pool);

  /// @return s, by inner vertex, in units of length as given. @pre factor() was true
  Eigen::VectorXd solve(const Eigen::VectorXd& force, const Eigen::VectorXd& turn) const;

 private:
  const AngleJacobian& jacobian_;
  SparseMatrix lower_;
  // Where the entries of each part go, in the order in which factor() comes to them.
  std::vector<std::size_t> cost_places_, square_places_, gradient_places_;
  SparseLdlt solver_;
};

}  // namespace planish
