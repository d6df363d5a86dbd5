#pragma once

#include <optional>
#include <vector>

#include "core/thread_pool.h"
#include "energy/angle_jacobian.h"
#include "energy/hinge_bending.h"
#include "energy/line_bending.h"
#include "energy/move_barrier.h"
#include "energy/proximity.h"
#include "energy/shape_guard.h"
#include "energy/strain_potential.h"
#include "evolve/auto/shared/border_motion.h"
#include "evolve/auto/shared/descent_limits.h"
#include "evolve/auto/shared/descent_strain.h"
#include "evolve/systems/kkt_system.h"
#include "evolve/systems/positions.h"

namespace planish {

/// Which way inner vertices go in a step: in all directions, or each along one line.
enum class SmoothMoves { free, along_lines };

/// What a step of SmoothDescent weighs.
struct SmoothWeights {
  /// A move of all vertices by this costs as much as all bending of the design. Share of the
  /// diagonal.
  double delta = 0.01;
  double sigma = 0.02;  ///< the rms of phi that costs as much, as a share of length
  double form = 0.0;    ///< share of the design's angles that bending is counted from, 0 to 1
};

/// Brings a patch nearer to flattenable while it stays smooth (docs/methods/smooth.md): steps of
/// Gauss and Newton, of all inner vertices at once, on
///
///     F(x) = B(x) / B0 + |x - x0|^2 / (n delta^2 D^2) + G(x) + |phi(x)|^2 / (N sigma^2),
///
/// B the bending of HingeBending, from a share of the angles of the design, B0 that of the design
/// from flat, the second term that of Proximity, n the vertices x has, so the border's too where it
/// may move, D the diagonal (of a rectangle that is as far spread), G of ShapeGuard, MoveBarrier
/// and LineBending, phi the N values of StrainPotential with a free border. The weights of hinges
/// and the matrix K of phi are those of the patch before a step, renewed after it. What has
/// orbits (PatchState::orbits()) stays its own mirror image.
class SmoothDescent {
 public:
  /// @param state as it was at first or later; must outlive it, as must the pool
  /// @param design the patch as it was at first, by the numbers of the state
  /// @param moves of inner vertices in a step: along lines it takes a quarter of the memory, and
  ///   solves three systems one after another, along normals and along two tangents
  SmoothDescent(PatchState& state, ThreadPool& pool, const Patch& design,
                const DescentLimits& limits, SmoothMoves moves = SmoothMoves::free);

  /// False where the patch allows no matrices.
  bool solvable() const { return potential_.solvable(); }

  const AngleJacobian& jacobian() const { return jacobian_; }
  const BorderMotion& border() const { return border_; }

  struct Step {
    std::size_t moved = 0;
    double merit_before = 0.0;
    double merit = 0.0;      ///< merit_before less what each part took off
    bool in_double = false;  ///< float did not do for a matrix
    int parts = 1;           ///< systems that were solved, 3 along lines
  };
  /// F falls, or nothing moves.
  Step step(const SmoothWeights& weights);

  /// As the patch is now. Strain of the edges of the pattern of least stretch, as estimated by phi;
  /// bending over that of the design; rms move over the diagonal, of the inner vertices and, where
  /// the border may move, of all of its vertices.
  const DescentStrain& strain() const { return strain_; }
  double bending() const { return bending_; }
  /// B0, k_no_bending at least.
  double design_bending() const { return design_bending_; }
  double deviation() const;
  /// How far the border may move over the diagonal: 0 where it slides, none where it stays.
  std::optional<double> border_reach() const;

  /// Of all vertices that may move, now and at first.
  Positions positions() const { return first_positions(state_, jacobian_.column_count()); }
  const Positions& origin() const { return origin_; }
  /// True if the limit of deviation held a vertex in the last step, or that of angles the step.
  bool at_deviation_limit() const { return at_deviation_limit_; }
  bool at_angle_limit() const { return at_angle_limit_; }
  void go_to(const Positions& positions);
  /// Frees what only steps need, until the next one.
  void release() { system_.release(); }

 private:
  /// Which way inner vertices go along lines: along the normal or one of two tangents.
  enum class MoveDirection { normal, tangent_u, tangent_v };
  struct Parts {
    double merit = 0.0;
    Eigen::VectorXd defects;
  };
  KktSystem::ForPairs pairs_of_terms() const;
  Eigen::VectorXd defects() const;
  Parts at(const Positions& positions);
  double merit(const Eigen::VectorXd& phi) const;
  void renew();
  /// Of all vertices that may move, from where they were at first.
  Positions moves() const { return sum_of(positions(), -1.0, origin_); }
  Positions lines(MoveDirection direction) const;
  Step step_along(std::optional<MoveDirection> direction);
  void assemble(std::optional<MoveDirection> direction, Positions& force);
  bool factor_system(double c);
  void assemble_shape(Positions& force);
  void assemble_moves(Positions& force);
  Positions within_limits(Positions positions) const;
  bool angles_hold();
  struct Trial {
    Positions positions;
    Parts parts;
  };
  Trial try_step(const Positions& before, const Eigen::VectorXd& defects, const Positions& full,
                 double share, bool corrected);
  Positions shortened(Positions step) const;

  PatchState& state_;
  ThreadPool& pool_;
  double design_bending_;
  DescentLimits limits_;
  bool along_lines_;
  BorderMotion border_;
  Positions origin_;
  AngleJacobian jacobian_;
  HingeBending hinges_;
  Proximity proximity_;
  ShapeGuard guard_;
  StrainPotential potential_;
  KktSystem system_;
  std::vector<BlockMatrix::Pair> hinge_pairs_, edge_pairs_;
  Eigen::VectorXd area_shares_;
  double diagonal_ = 0.0, unit_;
  Vec3 axis_;  // from the middle of the patch to the vertex that is furthest away
  MoveBarrier barrier_;
  LineBending border_bending_;
  SmoothWeights weights_;
  Eigen::VectorXd phi_;
  double stiffening_ = 0.0, bending_ = 1.0;
  DescentStrain strain_;
  bool at_deviation_limit_ = false, at_angle_limit_ = false;
};

}  // namespace planish
