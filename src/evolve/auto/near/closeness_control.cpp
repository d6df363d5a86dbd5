#include "evolve/auto/near/closeness_control.h"

#include <algorithm>

#include "core/math.h"

namespace planish {

ClosenessControl::ClosenessControl(const PatchState& state, double room,
                                   const ClosenessPace& schedule)
    : roughness_(state), pace_(schedule), least_(roughness_.now()) {
  most_ = least_ + room * (least_ + schedule.more);
}

double ClosenessControl::after_step(double closeness, double strain_left, bool may_grow) {
  using namespace tuning::prefer_near;
  const double roughness = roughness_.now();
  least_ = std::min(least_, roughness);
  first_strain_ = std::max(first_strain_, strain_left);
  const double left =
      first_strain_ > 0.0 ? math::pow(strain_left / first_strain_, pace_.allowance_exponent) : 0.0;
  const double allowed = least_ + (most_ - least_) * (1.0 - left);
  if (roughness > allowed) return std::max(k_closeness_ease * closeness, k_least_closeness);
  if (roughness >= k_plenty * allowed) return closeness;
  const double most = may_grow ? pace_.most : std::min(pace_.most, k_most_if_stiff);
  return std::max(closeness, std::min(k_closeness_growth * closeness, most));
}

bool ClosenessControl::is_too_rough() const {
  return roughness_.now() > most_;
}

}  // namespace planish
