#define PLANISH_ISA v4
#define PLANISH_LANES 8
#include "measure/simd/star_defects_lanes.h"

namespace planish {

void star_defects_v4(const Site* sites, const Star* stars, std::size_t count, std::size_t valence,
                     double* defects) {
  v4::star_defects(sites, stars, count, valence, defects);
}

}  // namespace planish
