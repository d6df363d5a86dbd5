#pragma once

#include <limits>
#include <vector>

#include "energy/angle_jacobian.h"
#include "energy/strain_potential.h"
#include "evolve/auto/near/closeness_control.h"
#include "evolve/auto/near/tangential_relaxation.h"
#include "evolve/auto/shared/border_motion.h"
#include "evolve/auto/shared/descent_limits.h"
#include "evolve/auto/shared/descent_strain.h"
#include "evolve/auto/shared/fairness_energy.h"
#include "evolve/auto/shared/tuning.h"
#include "evolve/systems/kkt_system.h"
#include "evolve/systems/positions.h"

namespace planish {

/// What a descent is to reach.
struct DescentAims {
  StrainLimits strain = {};  ///< at which it is to end, if given
  double room = 1.0;         ///< for roughness, spent on staying close; see ClosenessControl
  /// That a coarser level ended with: weights are found there, where steps cost little, and only
  /// lowered on the way here. 0: there is none.
  double closeness = 0.0;
  double allowance_exponent = 1.0;  ///< of the usual one; see ClosenessPace
};

using tuning::prefer_near::StepSchedule;

/// Brings a patch to where it is flattenable, smoothly and near where it began, all inner vertices
/// at once (docs/methods/auto.md): makes smaller and smaller, for sigma that falls from step to
/// step,
///
///     F(x) = C(x) + |phi(x)|^2 / (2 sigma^2),
///
/// C the FairnessEnergy, phi the StrainPotential, by Levenberg and Marquardt's steps along the
/// normals and slides along the surface where triangles get poor. Where a limit of strain is given,
/// phi is that of a pattern with a free border on the surface as it is, as that is what the limit
/// is of. Without one all strain has to go, and a border that is held leads there by a shorter way.
class StrainDescent {
 public:
  /// The patch is to be where it was at first: matrices are of that surface. The state must outlive
  /// it.
  StrainDescent(PatchState& state, ThreadPool& pool, const DescentAims& aims,
                const DescentLimits& limits);

  /// False where the patch allows no matrices.
  bool solvable() const { return potential_.solvable(); }
  const FairnessEnergy& cost() const { return cost_; }
  const AngleJacobian& jacobian() const { return jacobian_; }
  /// Of all vertices that may move.
  Positions positions() const { return first_positions(state_, border_.vertex_count()); }
  /// As they are now: they change from step to step. Sigma as on patches of 4,000 inner vertices.
  double closeness() const { return closeness_; }
  double sigma() const;

  /// Starts from where the vertices are now, or nearer to where they were at first if that is
  /// beyond the limits.
  void start(const StepSchedule& schedule);

  /// What a step did. F is that of the step's own sigma.
  struct Step {
    std::size_t moved = 0;
    double merit_before = 0.0, merit = 0.0;
    bool in_double = false;  ///< float did not do for the matrix
  };
  Step step();

  void go_to(const Positions& positions);
  /// Frees what only steps need, until the next one.
  void release() { system_.release(); }
  /// From now to the next start sigma is such that strain comes to its limit and stays there, from
  /// above or below.
  /// @param sigma to begin with, as sigma() tells it
  /// @pre there is a limit of strain
  void track_strain_limit(double sigma);

  /// Strain as of now; see DescentStrain.
  double rms_strain() const { return strain_.rms; }
  double max_strain() const { return strain_.most; }
  /// Of the vertices that may move, from where they were at first, rms.
  double deviation() const;
  /// True if the limit of strain, where there is one, is met.
  bool strain_is_met() const {
    return solvable() && aims_.strain.any() && headroom(aims_.strain, strain_) >= 1.0;
  }
  /// True if the patch is rougher than the room for roughness allows it to end.
  bool is_too_rough() const { return control_.is_too_rough(); }
  /// True if vertices came as far away as they may be.
  bool at_deviation_limit() const { return deviation_stopped_; }
  /// True if the last step was shortened by the limit of angles.
  bool at_angle_limit() const { return angle_stopped_; }

 private:
  double merit_at(const Positions& x);
  double merit() const;
  DescentStrain strain_now() const;
  Eigen::VectorXd defects() const;
  /// Measures the defects at the positions where vertices are, and phi.
  void update_strain();
  KktSystem::ForPairs pairs_of_cost() const;
  std::vector<Vec3> directions() const;
  Positions newton_step();
  Positions within_limits(Positions x) const;
  void hold_far_vertices();
  bool angles_hold();
  bool angles_hold_after_slides();
  double next_sigma(double share, const Step& step) const;
  double strain_to_go() const;
  void update_proximity_weight();

  PatchState& state_;
  ThreadPool& pool_;
  DescentAims aims_;
  DescentLimits limits_;
  std::vector<Triangle> triangles_;
  BorderMotion border_;
  AngleJacobian jacobian_;
  StrainPotential potential_;
  Eigen::VectorXd phi_;
  Eigen::VectorXd area_shares_;  // by vertex
  DescentStrain at_first_;
  double stays_;  // of that, at the limit: a share
  ClosenessPace pace_;
  ClosenessControl control_;
  double closeness_;
  FairnessEnergy cost_;
  KktSystem system_;
  std::vector<BlockMatrix::Pair> cost_pairs_;  // of the entries of the cost
  TangentialRelaxation relaxation_;
  Positions before_;  // the last step
  DescentStrain strain_;
  double longest_step_ = 0.0, fall_of_sigma_ = 0.5, sigma_ = 1.0, least_sigma_ = 0.0,
         stiffening_ = 0.0;
  bool tracks_limit_ = false, angle_stopped_ = false, deviation_stopped_ = false;
};

}  // namespace planish
