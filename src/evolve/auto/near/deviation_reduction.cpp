#include "evolve/auto/near/deviation_reduction.h"

namespace planish {

DeviationReduction::DeviationReduction(StrainDescent& descent)
    : descent_(descent),
      may_be_rough_(descent.is_too_rough()),
      nearest_(descent.positions()),
      deviation_(descent.deviation()) {
  descent_.track_strain_limit(descent_.sigma());
}

StrainDescent::Step DeviationReduction::step() {
  ++steps_;
  ++stagnant_steps_;
  const double closeness = descent_.closeness();
  const StrainDescent::Step step = descent_.step();
  // While the weight of proximity still grows, more is to come.
  if (descent_.closeness() > closeness) stagnant_steps_ = 0;
  const double deviation = descent_.deviation();
  const bool may_end = descent_.strain_is_met() && (may_be_rough_ || !descent_.is_too_rough());
  if (may_end && deviation < deviation_) {
    if (deviation < tuning::prefer_near::k_worth_it * deviation_) stagnant_steps_ = 0;
    nearest_ = descent_.positions();
    deviation_ = deviation;
  }
  return step;
}

}  // namespace planish
