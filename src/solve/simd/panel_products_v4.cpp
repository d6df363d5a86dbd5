#define PLANISH_ISA v4
#define PLANISH_LANES 8
#include "solve/simd/panel_products_lanes.h"

namespace planish {

PanelKernels panel_kernels_v4();

PanelKernels panel_kernels_v4() {
  return v4::panel_kernels();
}

}  // namespace planish
