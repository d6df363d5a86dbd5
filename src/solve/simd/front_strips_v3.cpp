#define PLANISH_ISA v3
#define PLANISH_LANES 4
#include "solve/simd/front_strips_lanes.h"

namespace planish {

FrontKernels front_kernels_v3();

FrontKernels front_kernels_v3() {
  return v3::front_kernels();
}

}  // namespace planish
