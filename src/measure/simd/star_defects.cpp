#include "measure/simd/star_defects.h"

namespace planish {

void star_defects_baseline(const Site*, const Star*, std::size_t, std::size_t, double*);
void star_defects_v3(const Site*, const Star*, std::size_t, std::size_t, double*);
void star_defects_v4(const Site*, const Star*, std::size_t, std::size_t, double*);

StarDefects star_defects_for([[maybe_unused]] Isa isa) {
#if defined(PLANISH_X86_64_LANES)
  if (isa == Isa::x86_64_v4) return star_defects_v4;
  if (isa == Isa::x86_64_v3) return star_defects_v3;
#endif
  return star_defects_baseline;
}

}  // namespace planish
