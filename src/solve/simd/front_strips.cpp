#include "solve/simd/front_strips.h"

namespace planish {

FrontKernels front_kernels_baseline();
FrontKernels front_kernels_v3();
FrontKernels front_kernels_v4();

namespace {

FrontKernels kernels_for([[maybe_unused]] Isa isa) {
#if defined(PLANISH_X86_64_LANES)
  if (isa == Isa::x86_64_v4) return front_kernels_v4();
  if (isa == Isa::x86_64_v3) return front_kernels_v3();
#endif
  return front_kernels_baseline();
}

}  // namespace

template <>
FrontKernel<double> front_kernel_for<double>(Isa isa) {
  return kernels_for(isa).of_double;
}

template <>
FrontKernel<float> front_kernel_for<float>(Isa isa) {
  return kernels_for(isa).of_float;
}

}  // namespace planish
