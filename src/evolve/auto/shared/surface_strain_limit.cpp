#include "evolve/auto/shared/surface_strain_limit.h"

#include <algorithm>
#include <limits>

#include "evolve/auto/shared/tuning.h"

namespace planish {

double SurfaceStrainLimit::share_of(const DescentStrain& strain) const {
  double share = std::numeric_limits<double>::infinity();
  if (most > 0.0) share = std::min(share, most / strain.most);
  if (rms > 0.0) share = std::min(share, tuning::k_of_rms_limit * rms / strain.rms);
  return share;
}

}  // namespace planish
