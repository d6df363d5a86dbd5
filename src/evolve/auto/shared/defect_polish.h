#pragma once

#include <optional>

#include <planish/evolve/evolver.h>
#include <planish/measure/flattenability.h>

#include "evolve/auto/shared/descent_limits.h"
#include "evolve/systems/least_norm_step.h"
#include "evolve/systems/positions.h"
#include "optimize/line_search.h"

namespace planish {

/// Takes the last defects out of a patch whose strain is small, in cycles of three parts that each
/// do what the others cannot (docs/methods/auto.md): a least-norm step for what is spread over the
/// patch, damped where it is not, controllable sweeps, which spread what is at single vertices, and
/// steps of the clusters around the largest defects. Energy falls in every cycle that moves
/// anything.
class DefectPolish {
 public:
  /// The state must outlive it, as must the pool. An angle that is sharper already is its own
  /// limit.
  DefectPolish(PatchState& state, ThreadPool& pool, const DescentLimits& limits);

  /// False where the border, or a hole that does not close, is taken to forbid the rest.
  /// @param strain that a descent has left, rms
  /// @param jacobian of the descent
  static bool can_finish(double strain, const AngleJacobian& jacobian);

  struct Cycle {
    std::size_t moved = 0;   ///< vertices
    bool flat = false;       ///< the patch is surely flattenable
    int slow = 0;            ///< this number in a row with a step have left most of the energy
    bool over = false;       ///< nothing moved, too many have stalled in a row, or it was the last
    bool in_double = false;  ///< float did not do for a matrix
  };
  Cycle cycle();
  /// The limit that held vertices in the last cycle.
  std::optional<StopReason> held_by() const { return held_by_; }

 private:
  /// @return how many vertices moved
  std::size_t move();
  Positions least_norm_step();
  void put(const Positions& positions);
  void sweep();
  /// Stops vertices at the limit of deviation, and puts those of triangles that got too sharp back.
  void keep_limits(const Positions& before);
  void stop_at_deviation();
  std::vector<Index> at_sharp_triangles() const;
  std::size_t moved_from(const Positions& before) const;

  PatchState& state_;
  ThreadPool& pool_;
  std::vector<Triangle> triangles_;
  DescentLimits limits_;
  std::vector<double> inverse_weights_;
  LeastNormStep least_;
  DampingRule damping_rule_;
  double damping_ = 1e-2;
  int cycles_ = 0, slow_cycles_ = 0, stalled_cycles_ = 0;
  std::optional<StopReason> held_by_;
};

}  // namespace planish
