#pragma once

#include <array>
#include <vector>

#include "evolve/state/patch_state.h"

namespace planish {

/// The roughness of a patch (Flattenability::roughness) while its vertices move.
class Roughness {
 public:
  /// O(n log n). The state must outlive it.
  explicit Roughness(const PatchState& state);

  /// As the patch is now, in degrees; 0 without inner edges. O(n).
  double now() const;

 private:
  const PatchState& state_;
  std::vector<std::array<Index, 4>> edges_;  // two ends, the corners left and right of it
};

}  // namespace planish
