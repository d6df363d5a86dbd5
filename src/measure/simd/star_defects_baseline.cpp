#define PLANISH_ISA baseline
#define PLANISH_LANES 2
#include "measure/simd/star_defects_lanes.h"

namespace planish {

void star_defects_baseline(const Site* sites, const Star* stars, std::size_t count,
                           std::size_t valence, double* defects) {
  baseline::star_defects(sites, stars, count, valence, defects);
}

}  // namespace planish
