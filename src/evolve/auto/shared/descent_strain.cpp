#include "evolve/auto/shared/descent_strain.h"

#include <algorithm>
#include <limits>

#include "evolve/auto/shared/tuning.h"

namespace planish {

double headroom(const StrainLimits& limits, const DescentStrain& strain) {
  double factor = std::numeric_limits<double>::infinity();
  if (limits.max > 0.0) factor = std::min(factor, limits.max / strain.most);
  if (limits.rms > 0.0)
    factor = std::min(factor, tuning::k_rms_limit_share * limits.rms / strain.rms);
  return factor;
}

}  // namespace planish
