#pragma once

#include <cstddef>

#include "solve/mixed_ldlt.h"

namespace planish {

/// With more inner vertices a patch, or a level of one, is dense: the matrices of its steps are
/// factored in float.
inline constexpr std::size_t k_dense = 10'000;
/// With more inner vertices SmoothDescent moves them along one line each at a time: in all
/// directions at once they would need four times the memory.
inline constexpr std::size_t k_large = 20'000;
/// Of the solutions for steps on dense patches; see MixedLdlt.
inline constexpr double k_step_accuracy = 1e-3;

inline bool is_dense(std::size_t inner_vertices) {
  return inner_vertices > k_dense;
}

inline Precision step_precision(std::size_t inner_vertices) {
  return is_dense(inner_vertices) ? Precision::mixed : Precision::full;
}

/// Of StrainPotential.
inline Precision potential_precision(std::size_t inner_vertices) {
  return is_dense(inner_vertices) ? Precision::rounded : Precision::full;
}

}  // namespace planish
