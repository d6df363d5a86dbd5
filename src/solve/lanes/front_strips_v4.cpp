#define PLANISH_ISA v4
#define PLANISH_LANES 8
#include "solve/lanes/front_strips_lanes.h"

namespace planish {

FrontKernel front_kernel_v4();

FrontKernel front_kernel_v4() {
  return {v4::factor_diagonal, v4::solve_strips, v4::update_strips};
}

}  // namespace planish
