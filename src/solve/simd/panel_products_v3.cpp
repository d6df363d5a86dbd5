#define PLANISH_ISA v3
#define PLANISH_LANES 4
#include "solve/simd/panel_products_lanes.h"

namespace planish {

PanelKernels panel_kernels_v3();

PanelKernels panel_kernels_v3() {
  return v3::panel_kernels();
}

}  // namespace planish
