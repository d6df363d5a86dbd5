#pragma once

#include <planish/evolve/method.h>

#include "evolve/patch_state.h"
#include "evolve/ring_energy.h"

namespace planish {

/// Moves one vertex after another as controllable Laplacian evolution does; one for each thread.
class ControllableMover {
 public:
  /// Options and state must outlive it.
  ControllableMover(const ControllableLaplacian& options, PatchState& state);

  /// Takes the step along the Laplacian vector that lowers the ring energy of v, if there is one.
  /// The energy of the whole patch falls then, and nothing changes otherwise.
  /// @return true if the vertex moved
  bool move(std::size_t v);

 private:
  bool accepts(std::size_t v, Vec3 target, double enough);

  const ControllableLaplacian& options_;
  PatchState& state_;
  double radius_, angle_limit_;
  bool guarded_;
  RingEnergy ring_;
};

}  // namespace planish
