#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/core/vec.h>

#include "evolve/state/patch_state.h"

namespace planish {

/// Watches that each move lowers the ring energy, which it computes from the positions alone, one
/// arctangent an angle. For builds with the option PLANISH_CHECK_MOVES, and slow. What may be
/// visited at the same time may be watched at the same time: neither looks at positions that the
/// other moves.
class MoveCheck {
 public:
  /// A ring energy, and how far rounding may be off: by anything where edges are shorter than
  /// 1e-70 of the size of the patch.
  struct Energy {
    double value = 0.0, rounding = 0.0;
  };

  /// Whether this build checks every move.
  static bool is_wanted();

  /// The state must outlive it.
  explicit MoveCheck(const PatchState& state);

  /// b_v of an inner vertex.
  Energy energy(std::size_t v) const;

  /// To be called after a move.
  /// @throws std::logic_error if the energy has risen
  void require_fall(std::size_t v, Energy before) const;

 private:
  double defect(std::size_t v) const;
  bool has_digits(std::size_t v) const;

  const PatchState* state_;
  std::vector<std::span<const Index>> rings_;
};

}  // namespace planish
