#define PLANISH_ISA v3
#define PLANISH_LANES 4
#include "evolve/simd/move_stars_lanes.h"

namespace planish {

void move_stars_v3(const MoveOptions& options, Site* sites, Changes changes, const Star* stars,
                   std::size_t count, std::size_t valence, unsigned char* moved) {
  v3::move_stars(options, sites, changes, stars, count, valence, moved);
}

}  // namespace planish
