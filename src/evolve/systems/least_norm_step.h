#pragma once

#include <vector>

#include "energy/angle_jacobian.h"
#include "evolve/systems/dual_system.h"
#include "evolve/systems/positions.h"

namespace planish {

/// The least moves of all inner vertices that change the angle sums as asked, by weights and as far
/// as damping lets them: S A^T (A S A^T + mu D)^-1 change (docs/methods/least_norm.md).
class LeastNormStep {
 public:
  /// @param inverse_weights S = W^-2, by inner vertex
  /// @param max_step no vertex goes further in a step, in its shortest edges
  /// @param state must outlive it, as must the pool
  LeastNormStep(PatchState& state, std::vector<double> inverse_weights, double max_step,
                ThreadPool& pool, Precision precision = Precision::full);
  LeastNormStep(const LeastNormStep&) = delete;
  LeastNormStep& operator=(const LeastNormStep&) = delete;

  const AngleJacobian& jacobian() const { return jacobian_; }
  DualSystem& dual() { return dual_; }

  /// Takes the gradients from where the vertices are now.
  void update() { jacobian_.update(state_.positions(), pool_); }
  /// @return false where the matrix cannot be factored
  bool factor(double mu) { return dual_.factor(inverse_weights_, mu, pool_); }
  /// @pre factor() was true
  Positions step_for(const Eigen::VectorXd& angle_change);

  /// A move and how its end bends: the first t of it are t first + t^2/2 second.
  struct Curve {
    Positions first, second;
    double fall = 0.0;    // of the energy, to first order
    bool solves = false;  // whether it closes the angle sums to first order, in spite of damping
    Positions move(double t) const;
  };
  /// The least move that closes the defects of the last measure(), bent so that the angle sums go
  /// on straight to second order (geodesic acceleration, Transtrum and Sethna 2012): the second
  /// derivative of the angle sums along the move is what one look ahead shows them to miss.
  /// @pre factor() was true, and vertices are where it was. The defects are to be measured again.
  Curve to_close_defects();

  /// The move with every vertex stopped at its longest step: a few needles must not hold up the
  /// rest.
  Positions stopped(Positions move) const;

 private:
  PatchState& state_;
  ThreadPool& pool_;
  std::vector<double> inverse_weights_;
  double max_step_;
  AngleJacobian jacobian_;
  DualSystem dual_;
};

}  // namespace planish
