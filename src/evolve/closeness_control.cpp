#include "evolve/closeness_control.h"

#include <algorithm>
#include <cmath>

namespace planish {

ClosenessControl::ClosenessControl(const PatchState& state, double room, const ClosenessPace& pace)
    : roughness_(state), pace_(pace), least_(roughness_.now()) {
  constexpr double more = 2.0;  // degrees
  most_ = least_ + room * (least_ + more);
}

double ClosenessControl::after_step(double closeness, double strain_left) {
  constexpr double plenty = 0.8, ease = 0.25, least_closeness = 0.005;
  const double roughness = roughness_.now();
  least_ = std::min(least_, roughness);
  first_strain_ = std::max(first_strain_, strain_left);
  const double gone = first_strain_ > 0.0 ? 1.0 - std::sqrt(strain_left / first_strain_) : 1.0;
  const double allowed = least_ + (most_ - least_) * gone;
  if (roughness > allowed) return std::max(ease * closeness, least_closeness);
  if (roughness < plenty * allowed) return std::min(pace_.growth * closeness, pace_.most);
  return closeness;
}

}  // namespace planish
