#define PLANISH_ISA v4
#define PLANISH_LANES 8
#include "evolve/simd/move_stars_lanes.h"

namespace planish {

void move_stars_v4(const MoveOptions& options, Site* sites, Changes changes, const Star* stars,
                   std::size_t count, std::size_t valence, unsigned char* moved) {
  v4::move_stars(options, sites, changes, stars, count, valence, moved);
}

}  // namespace planish
