#define PLANISH_ISA v3
#define PLANISH_LANES 4
#include "measure/simd/star_defects_lanes.h"

namespace planish {

void star_defects_v3(const Site* sites, const Star* stars, std::size_t count, std::size_t valence,
                     double* defects) {
  v3::star_defects(sites, stars, count, valence, defects);
}

}  // namespace planish
