#include "solve/simd/panel_products.h"

namespace planish {

PanelKernels panel_kernels_baseline();
PanelKernels panel_kernels_v3();
PanelKernels panel_kernels_v4();

namespace {

PanelKernels panel_kernels_for([[maybe_unused]] Isa isa) {
#if defined(PLANISH_X86_64_LANES)
  if (isa == Isa::x86_64_v4) return panel_kernels_v4();
  if (isa == Isa::x86_64_v3) return panel_kernels_v3();
#endif
  return panel_kernels_baseline();
}

}  // namespace

template <>
PanelKernel<double> panel_kernel_for<double>(Isa isa) {
  return panel_kernels_for(isa).of_double;
}

template <>
PanelKernel<float> panel_kernel_for<float>(Isa isa) {
  return panel_kernels_for(isa).of_float;
}

}  // namespace planish
