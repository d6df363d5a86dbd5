#define PLANISH_ISA baseline
#define PLANISH_LANES 2
#include "evolve/lanes/move_stars_lanes.h"

namespace planish {

void move_stars_baseline(const MoveOptions& options, Site* sites, std::size_t inner_count,
                         const Star* stars, std::size_t count, std::size_t valence,
                         unsigned char* moved) {
  baseline::move_stars(options, sites, inner_count, stars, count, valence, moved);
}

}  // namespace planish
