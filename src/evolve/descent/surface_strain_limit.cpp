#include "evolve/descent/surface_strain_limit.h"

#include <algorithm>
#include <limits>

namespace planish {

double StrainLimit::share_of(const DescentStrain& strain) const {
  // The pattern itself has up to so much more than phi tells, on all but very uneven meshes.
  constexpr double of_limit = 0.95;
  double share = std::numeric_limits<double>::infinity();
  if (most > 0.0) share = std::min(share, most / strain.most);
  if (rms > 0.0) share = std::min(share, of_limit * rms / strain.rms);
  return share;
}

}  // namespace planish
