#define PLANISH_ISA v3
#define PLANISH_LANES 4
#include "solve/lanes/front_strips_lanes.h"

namespace planish {

FrontKernel front_kernel_v3();

FrontKernel front_kernel_v3() {
  return {v3::factor_diagonal, v3::solve_strips, v3::update_strips};
}

}  // namespace planish
