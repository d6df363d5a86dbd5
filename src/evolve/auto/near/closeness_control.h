#pragma once

#include "evolve/auto/near/roughness.h"
#include "evolve/auto/shared/tuning.h"

namespace planish {

using tuning::prefer_near::ClosenessPace;

/// Spends the roughness that a patch may have on staying close to where it was. Crumples that are
/// made early stay for good, so the allowance grows with the strain that is gone
/// (docs/methods/auto.md):
///
///     r_least + (r_most - r_least) (1 - (s / s_first)^allowance_exponent)
class ClosenessControl {
 public:
  /// @param state as it was at first; must outlive it
  /// @param room how much rougher the patch may get: r_most = r_first + room (r_first + more)
  ClosenessControl(const PatchState& state, double room, const ClosenessPace& schedule);

  /// What closeness is to be after a step, as the patch is now.
  /// @param strain_left s, on any scale that stays the same
  /// @param may_grow false where steps fall short already: then to k_most_if_stiff
  double after_step(double closeness, double strain_left, bool may_grow);

  /// True if the patch is rougher now than it may end.
  bool is_too_rough() const;

 private:
  Roughness roughness_;
  ClosenessPace pace_;
  double least_, most_;  // roughness
  double first_strain_ = 0.0;
};

}  // namespace planish
