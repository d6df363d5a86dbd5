#define PLANISH_ISA baseline
#define PLANISH_LANES 2
#include "evolve/simd/move_stars_lanes.h"

namespace planish {

void move_stars_baseline(const MoveOptions& options, Site* sites, Changes changes,
                         const Star* stars, std::size_t count, std::size_t valence,
                         unsigned char* moved) {
  baseline::move_stars(options, sites, changes, stars, count, valence, moved);
}

}  // namespace planish
