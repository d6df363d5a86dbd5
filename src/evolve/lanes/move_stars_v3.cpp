#define PLANISH_ISA v3
#define PLANISH_LANES 4
#include "evolve/lanes/move_stars_lanes.h"

namespace planish {

void move_stars_v3(const MoveOptions& options, Site* sites, std::size_t inner_count,
                   const Star* stars, std::size_t count, std::size_t valence,
                   unsigned char* moved) {
  v3::move_stars(options, sites, inner_count, stars, count, valence, moved);
}

}  // namespace planish
