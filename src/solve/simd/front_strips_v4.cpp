#define PLANISH_ISA v4
#define PLANISH_LANES 8
#include "solve/simd/front_strips_lanes.h"

namespace planish {

FrontKernels front_kernels_v4();

FrontKernels front_kernels_v4() {
  return v4::front_kernels();
}

}  // namespace planish
