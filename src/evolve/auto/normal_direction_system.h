#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "evolve/systems/angle_jacobian.h"
#include "evolve/systems/dense.h"
#include "solve/mixed_ldlt.h"

namespace planish {

/// The steps of vertices along directions n_m that a cost of shape allows and that bring strain
/// down: of the step s and the multipliers y
///
///     [ stiffness H_n     J^T        ] [s]   [force]
///     [ J              -sigma^2 K K^T ] [y] = [dtheta]
///
/// H_n the cost's matrix, its entries times n_m . n_k; J = d d / d s the defects' Jacobian along
/// the directions; K the matrix of StrainPotential, by inner vertex and value of phi.
/// Quasi-definite. Each inner vertex has one direction, its normal, so two unknowns: moves along
/// the surface would double the unknowns and hardly change its form. Vertices of the border have as
/// many as BorderMotion says. What is "by direction" is in the order of the vertices.
class NormalDirectionSystem {
 public:
  /// The numbers of the steps: one of each inner vertex, then those of the border's.
  struct Steps {
    int inner, per_border_vertex;

    int count_of(int v) const { return v < inner ? 1 : per_border_vertex; }
    int first_of(int v) const { return v < inner ? v : inner + per_border_vertex * (v - inner); }
    int vertex_of(int step) const {
      return step < inner ? step : inner + (step - inner) / per_border_vertex;
    }
    /// Their unknowns: a step and a multiplier of each inner vertex in turns, then the rest.
    int unknown(int step) const { return step < inner ? 2 * step : inner + step; }
    static int multiplier_of(int v) { return 2 * v + 1; }
  };

  /// @param cost,square lower halves, by column of the jacobian and by inner vertex; their patterns
  ///   stay
  /// @param border_directions of each vertex of the border
  /// @param jacobian must outlive it
  NormalDirectionSystem(const AngleJacobian& jacobian, const PatchState& state,
                        const SparseMatrix& cost, const SparseMatrix& square,
                        int border_directions = 0);

  const Steps& steps() const { return steps_; }

  /// Factors for the gradients as they are; false where that cannot be.
  /// @param directions of unit length; those of a vertex at right angles
  /// @param unit of length of steps
  bool factor(std::span<const Vec3> directions, const SparseMatrix& cost,
              const SparseMatrix& square, double unit, double stiffness, double sigma,
              ThreadPool& pool);

  /// @return s, in units of length as given. @pre factor() was true
  /// @param force by direction
  /// @param angle_change by inner vertex
  /// @param accuracy as of MixedLdlt
  Eigen::VectorXd solve(const Eigen::VectorXd& force, const Eigen::VectorXd& angle_change,
                        ThreadPool& pool, double accuracy = k_step_accuracy);

  /// Frees the factor, until the next one is made.
  void release() { solver_.release(); }
  /// Whether float did not do for the last matrix.
  bool fell_back() const { return solver_.fell_back(); }

 private:
  const AngleJacobian& jacobian_;
  Steps steps_;
  SparseMatrix lower_;
  // Where the entries of each part go, in the order in which factor() comes to them.
  std::vector<std::uint32_t> cost_entries_, square_entries_, gradient_entries_;
  MixedLdlt solver_;
};

}  // namespace planish
