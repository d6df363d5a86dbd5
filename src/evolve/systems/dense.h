#pragma once

#include <cstddef>

#include "solve/mixed_ldlt.h"

namespace planish {

/// With more inner vertices a patch, or a level of one, is dense: the matrices of its steps are
/// factored in float.
inline constexpr std::size_t k_dense = 10'000;
/// With more inner vertices in the patch, SmoothDescent moves those of its dense levels only along
/// their normals. Smaller patches can afford all directions, and end nearer.
inline constexpr std::size_t k_normals_only = 20'000;
/// Of the solutions for steps on dense patches; see MixedLdlt.
inline constexpr double k_step_accuracy = 1e-3;

inline bool is_dense(std::size_t inner_vertices) {
  return inner_vertices > k_dense;
}

inline Precision step_precision(std::size_t inner_vertices) {
  return is_dense(inner_vertices) ? Precision::mixed : Precision::full;
}

}  // namespace planish
