#pragma once

#include <string_view>
#include <vector>

namespace planish {

/// The sets of instructions that lane kernels are compiled for: the same bits from each.
enum class Isa { baseline, x86_64_v3, x86_64_v4 };

/// "baseline", "x86-64-v3" or "x86-64-v4".
std::string_view to_string(Isa isa);

/// Those that this processor has and that were compiled in, slowest first; baseline always.
std::vector<Isa> available_isas();

/// The last of available_isas().
Isa best_isa();

/// Which of the instructions that bear on speed this processor has: "avx2", "fma", "avx512f".
/// Empty on processors of other kinds than x86-64.
std::vector<std::string_view> processor_features();

}  // namespace planish
