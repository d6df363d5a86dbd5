#define PLANISH_ISA baseline
#define PLANISH_LANES 2
#include "solve/simd/panel_products_lanes.h"

namespace planish {

PanelKernels panel_kernels_baseline();

PanelKernels panel_kernels_baseline() {
  return baseline::panel_kernels();
}

}  // namespace planish
