#pragma once

#include <planish/measure/limit_check.h>

namespace planish {

/// Strain by the potential phi, as a share of length.
struct DescentStrain {
  double rms = 0.0;   ///< with a limit of strain that of the pattern's edges (edge_strain_of()),
                      ///< else of phi over the inner vertices
  double most = 0.0;  ///< of |phi|: edges along the border of the pattern stretch by that much,
                      ///< those inside by half of it and more
};

/// What strain is to be multiplied by to be at the limit; infinite where there is none.
/// @param limits as StrainLimits::of_form()
double headroom(const StrainLimits& limits, const DescentStrain& strain);

}  // namespace planish
