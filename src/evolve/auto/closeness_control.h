#pragma once

#include "evolve/descent/roughness.h"

namespace planish {

/// How closeness, the weight of staying near against being smooth, changes on the way.
struct ClosenessPace {
  double first;               ///< of a descent from scratch
  double most;                ///< what it grows to where there is room for roughness
  double allowance_exponent;  ///< power of the strain that is left: the greater, the sooner there
                              ///< is room
  double more;                ///< degrees by which r_most exceeds r_first (1 + room), over room
};
/// On the way to flattenable, where weights beyond `most` cost steps and bring little.
inline constexpr ClosenessPace k_usual_closeness{0.05, 8.0, 0.8, 2.5};
/// What closeness grows to where steps fall short already.
inline constexpr double k_most_if_stiff = 0.5;
/// Where the way ends at a limit of strain, on patches of 4,000 vertices: what closeness begins
/// with where hardly any strain has to go, what it grows to, and its allowance_exponent.
inline constexpr double k_first_near = 2.0, k_most_near = 50.0, k_earliness_near = 1.3;

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
