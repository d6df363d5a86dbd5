#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <planish/evolve/method.h>

#include "evolve/simd/move_stars.h"
#include "evolve/state/patch_state.h"
#include "evolve/vertex_step/move_check.h"

namespace planish {

/// Moves vertices as controllable Laplacian evolution does. A vertex that found no step is left
/// out until its ring changes: it would find none again.
class ControllableMover {
 public:
  /// The state must outlive it.
  ControllableMover(const ControllableLaplacian& options, PatchState& state, Isa isa = best_isa());

  /// Lets the vertices visited from begin to end take the step along their Laplacian vectors that
  /// lowers the ring energy, where there is one. The energy of the patch falls with each. What the
  /// plan lets be visited at the same time may be moved at the same time.
  /// @return how many moved
  std::size_t move(std::size_t begin, std::size_t end);

  /// Lets every vertex be tried again; that it was left out never changes a result.
  void forget_idle() { std::fill(idle_since_.begin(), idle_since_.end(), 0); }

 private:
  static constexpr std::size_t k_batch = 128;
  /// Stars that are handed to the kernel together.
  struct Batch {
    std::array<Star, k_batch> stars;
    std::array<Index, k_batch> visits;
    std::size_t count = 0;
  };

  /// Moves those of the batch and empties it.
  std::size_t move_batch(Batch& batch, const Run& run);

  PatchState& state_;
  MoveOptions options_;
  MoveStars move_stars_;
  std::vector<Site> origins_;              // where a limit of deviation needs them
  std::optional<MoveCheck> check_;         // in builds that check every move
  std::vector<std::uint32_t> idle_since_;  // by visit: when it found no step; 0: it moved
};

}  // namespace planish
