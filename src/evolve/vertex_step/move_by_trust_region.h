#pragma once

#include "evolve/simd/move_stars.h"

namespace planish {

/// A MoveStars that looks for the step by the solver that the paper names, one vertex after another
/// (trust_region.h). Steps are accepted by the same rule.
void move_by_trust_region(const MoveOptions& options, Site* sites, Changes changes,
                          const Star* stars, std::size_t count, std::size_t valence,
                          unsigned char* moved);

}  // namespace planish
