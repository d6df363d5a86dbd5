#include "core/simd/isa.h"

namespace planish {

std::string_view to_string(Isa isa) {
  switch (isa) {
    case Isa::baseline:
      return "baseline";
    case Isa::x86_64_v3:
      return "x86-64-v3";
    case Isa::x86_64_v4:
      return "x86-64-v4";
  }
  return "unknown";
}

std::vector<Isa> available_isas() {
  std::vector<Isa> isas{Isa::baseline};
#if defined(PLANISH_X86_64_LANES)
  constexpr std::string_view widest = PLANISH_LANES_AT_MOST;
  if (widest != to_string(Isa::baseline) && __builtin_cpu_supports("avx2")) {
    isas.push_back(Isa::x86_64_v3);
    if (widest != to_string(Isa::x86_64_v3) && __builtin_cpu_supports("avx512f") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl")) {
      isas.push_back(Isa::x86_64_v4);
    }
  }
#endif
  return isas;
}

Isa best_isa() {
  static const Isa best = available_isas().back();
  return best;
}

std::vector<std::string_view> processor_features() {
  std::vector<std::string_view> features;
#if defined(PLANISH_X86_64_LANES)
  // The compiler takes literals only.
  if (__builtin_cpu_supports("sse4.2")) features.emplace_back("sse4.2");
  if (__builtin_cpu_supports("avx")) features.emplace_back("avx");
  if (__builtin_cpu_supports("avx2")) features.emplace_back("avx2");
  if (__builtin_cpu_supports("fma")) features.emplace_back("fma");
  if (__builtin_cpu_supports("avx512f")) features.emplace_back("avx512f");
  if (__builtin_cpu_supports("avx512dq")) features.emplace_back("avx512dq");
  if (__builtin_cpu_supports("avx512vl")) features.emplace_back("avx512vl");
#endif
  return features;
}

}  // namespace planish
