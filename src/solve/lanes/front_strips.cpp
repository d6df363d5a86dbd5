#include "solve/lanes/front_strips.h"

namespace planish {

FrontKernel front_kernel_baseline();
FrontKernel front_kernel_v3();
FrontKernel front_kernel_v4();

FrontKernel front_kernel_for([[maybe_unused]] Isa isa) {
#if defined(PLANISH_X86_64_LANES)
  if (isa == Isa::x86_64_v4) return front_kernel_v4();
  if (isa == Isa::x86_64_v3) return front_kernel_v3();
#endif
  return front_kernel_baseline();
}

}  // namespace planish
