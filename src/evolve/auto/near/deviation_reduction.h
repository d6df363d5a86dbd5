#pragma once

#include "evolve/auto/near/strain_descent.h"
#include "evolve/auto/shared/tuning.h"

namespace planish {

/// Pulls a patch whose strain has come within its limit back towards where it was at first: further
/// steps of the descent, which now keep the strain where it is, and of the positions they come to
/// the nearest that is within the limit.
class DeviationReduction {
 public:
  /// @param descent its strain is met; must outlive it
  explicit DeviationReduction(StrainDescent& descent);

  StrainDescent::Step step();
  /// True where going on would bring little.
  bool over() const {
    return stagnant_steps_ >= tuning::prefer_near::k_most_idle_reduction_steps ||
           steps_ >= tuning::prefer_near::k_most_reduction_steps;
  }
  /// Goes to the nearest place found.
  void finish() { descent_.go_to(nearest_); }

 private:
  StrainDescent& descent_;
  bool may_be_rough_;  // as it was already
  Positions nearest_;
  double deviation_;  // of the nearest
  int steps_ = 0, stagnant_steps_ = 0;
};

}  // namespace planish
