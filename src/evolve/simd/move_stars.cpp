#include "evolve/simd/move_stars.h"

namespace planish {

void move_stars_baseline(const MoveOptions&, Site*, Changes, const Star*, std::size_t, std::size_t,
                         unsigned char*);
void move_stars_v3(const MoveOptions&, Site*, Changes, const Star*, std::size_t, std::size_t,
                   unsigned char*);
void move_stars_v4(const MoveOptions&, Site*, Changes, const Star*, std::size_t, std::size_t,
                   unsigned char*);

MoveStars move_stars_for([[maybe_unused]] Isa isa) {
#if defined(PLANISH_X86_64_LANES)
  if (isa == Isa::x86_64_v4) return move_stars_v4;
  if (isa == Isa::x86_64_v3) return move_stars_v3;
#endif
  return move_stars_baseline;
}

}  // namespace planish
