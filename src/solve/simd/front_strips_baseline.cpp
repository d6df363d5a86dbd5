#define PLANISH_ISA baseline
#define PLANISH_LANES 2
#include "solve/simd/front_strips_lanes.h"

namespace planish {

FrontKernels front_kernels_baseline();

FrontKernels front_kernels_baseline() {
  return baseline::front_kernels();
}

}  // namespace planish
