#pragma once

#include "core/simd/isa.h"
#include "core/simd/stars.h"

namespace planish {

/// What a controllable sweep does to each vertex. Lengths in the units of the sites.
struct MoveOptions {
  double lambda_min, lambda_max;
  double max_cotangent;  // of the angle that no triangle may fall below; +infinity for none
  double radius;         // no vertex ends further from its origin; +infinity for no limit
  const Site* origins;   // of all sites; needed where radius is finite
};

/// When the place or defect of each inner vertex changed last.
struct Changes {
  std::uint32_t* changed_at;
  std::uint32_t now;
};

/// Takes, for each of `count` inner vertices of one colour and of `valence` neighbours, the step
/// along its Laplacian vector that lowers its ring energy most, if there is one; several vertices
/// at a time. Writes positions and defects into sites and notes what changed.
/// @param moved gets 1 for each star whose centre moved, else 0
using MoveStars = void (*)(const MoveOptions& options, Site* sites, Changes changes,
                           const Star* stars, std::size_t count, std::size_t valence,
                           unsigned char* moved);

MoveStars move_stars_for(Isa isa);

}  // namespace planish
