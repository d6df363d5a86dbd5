#pragma once

#include "core/simd/isa.h"
#include "core/simd/stars.h"

namespace planish {

/// Computes the angle defects of stars that all have `valence` neighbours into defects[0] to
/// defects[count - 1], radians, several stars at a time. Bits do not depend on the instruction set
/// or on which stars are computed together. Sites' defects are not looked at.
using StarDefects = void (*)(const Site* sites, const Star* stars, std::size_t count,
                             std::size_t valence, double* defects);

StarDefects star_defects_for(Isa isa);

}  // namespace planish
