#pragma once

#include "evolve/roughness.h"

namespace planish {

/// How closeness, the weight of staying near against being smooth, changes on the way.
struct ClosenessPace {
  double first;   ///< of a descent from scratch
  double growth;  ///< factor where there is room for roughness
  double most;
};
/// On the way to flattenable, where weights beyond `most` cost steps and bring little.
inline constexpr ClosenessPace k_smooth_first{0.05, 2.0, 0.5};
/// Where the way ends sooner, at a limit of strain: less of the roughness comes along.
inline constexpr ClosenessPace k_near_first{2.0, 2.0, 50.0};

/// Spends the roughness that a patch may have on staying close to where it was. Crumples that are
/// made early stay for good, so the allowance grows with the strain that is gone
/// (docs/methods/auto.md):
///
///     r_least + (r_most - r_least) (1 - sqrt(s / s_first))
class ClosenessControl {
 public:
  /// @param state as it was at first; must outlive it
  /// @param room how much rougher the patch may get: r_most = r_first + room (r_first + 2 degrees)
  ClosenessControl(const PatchState& state, double room, const ClosenessPace& pace);

  /// What closeness is to be after a step, as the patch is now.
  /// @param strain_left s, on any scale that stays the same
  double after_step(double closeness, double strain_left);

 private:
  Roughness roughness_;
  ClosenessPace pace_;
  double least_, most_;  // roughness
  double first_strain_ = 0.0;
};

}  // namespace planish
