#define PLANISH_ISA baseline
#define PLANISH_LANES 2
#include "solve/lanes/front_strips_lanes.h"

namespace planish {

FrontKernel front_kernel_baseline();

FrontKernel front_kernel_baseline() {
  return {baseline::factor_diagonal, baseline::solve_strips, baseline::update_strips};
}

}  // namespace planish
