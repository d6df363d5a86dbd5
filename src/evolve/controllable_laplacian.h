#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <planish/evolve/method.h>

#include "evolve/lanes/move_stars.h"
#include "evolve/patch_state.h"

namespace planish {

/// Moves vertices as controllable Laplacian evolution does. A vertex that found no step is left
/// out until its ring changes: it would find none again.
class ControllableMover {
 public:
  /// The state must outlive it.
  ControllableMover(const ControllableLaplacian& options, PatchState& state, Isa isa = best_isa());

  /// Lets the vertices visited from begin to end, which are of one colour, take the step along
  /// their Laplacian vectors that lowers the ring energy, where there is one. The energy of the
  /// patch falls with each. Parts of one colour may be moved at the same time.
  /// @return how many moved
  std::size_t move(std::size_t begin, std::size_t end);

  /// Lets every vertex be tried again; that it was left out never changes a result.
  void forget_idle() { std::fill(idle_since_.begin(), idle_since_.end(), 0); }

 private:
  std::size_t move_batch(std::span<const Star> stars, std::size_t valence);

  PatchState& state_;
  MoveOptions options_;
  MoveStars move_stars_;
  std::vector<Site> origins_;              // where a limit of deviation needs them
  std::vector<std::uint32_t> idle_since_;  // the phase in which it found no step; 0: it moved
};

}  // namespace planish
