// Included by one source file for each set of instructions.
#pragma once

#include "core/simd/simd.h"
#include "solve/simd/panel_products.h"

namespace planish::PLANISH_ISA {

constexpr std::size_t k_together = 4;  // columns whose products are summed before they are added,
                                       // as many as a block of a triangle has
constexpr std::size_t k_sums = 4;      // independent sums of a column's products

using Sums = double __attribute__((vector_size(8 * k_sums)));

/// As many numbers as the vector has, as doubles.
template <class Vector>
inline void load_wide(const double* from, Vector& x) {
  __builtin_memcpy(&x, from, sizeof x);
}

template <class Vector>
inline void load_wide(const float* from, Vector& x) {
  float __attribute__((vector_size(sizeof(Vector) / 2))) narrow;
  __builtin_memcpy(&narrow, from, sizeof narrow);
  x = __builtin_convertvector(narrow, Vector);
}

enum class Sign { plus, minus };

/// y[i] += or -= the sum over the columns: four columns at once, then one by one.
template <Sign sign, class T>
inline void combine_product(const Panel<T>& l, const double* __restrict x, double* __restrict y) {
  constexpr std::size_t lanes = PLANISH_LANES;
  std::size_t k = 0;
  for (; k + k_together <= l.columns; k += k_together) {
    const T *l0 = l.values + k * l.stride, *l1 = l0 + l.stride, *l2 = l1 + l.stride,
            *l3 = l2 + l.stride;
    const double x0 = x[k], x1 = x[k + 1], x2 = x[k + 2], x3 = x[k + 3];
    std::size_t i = 0;
    for (; i + lanes <= l.rows; i += lanes) {
      Real a, b, c, d, own;
      load_wide(l0 + i, a);
      load_wide(l1 + i, b);
      load_wide(l2 + i, c);
      load_wide(l3 + i, d);
      load_wide(y + i, own);
      const Real sum = (a * x0 + b * x1) + (c * x2 + d * x3);
      own = sign == Sign::plus ? own + sum : own - sum;
      __builtin_memcpy(y + i, &own, sizeof own);
    }
    for (; i < l.rows; ++i) {
      const double sum = (static_cast<double>(l0[i]) * x0 + static_cast<double>(l1[i]) * x1) +
                         (static_cast<double>(l2[i]) * x2 + static_cast<double>(l3[i]) * x3);
      y[i] = sign == Sign::plus ? y[i] + sum : y[i] - sum;
    }
  }
  for (; k < l.columns; ++k) {
    const T* own = l.values + k * l.stride;
    for (std::size_t i = 0; i < l.rows; ++i) {
      const double product = static_cast<double>(own[i]) * x[k];
      y[i] = sign == Sign::plus ? y[i] + product : y[i] - product;
    }
  }
}

/// Subtracts from y, for each of so many columns, the sum of its products with x.
template <std::size_t count, class T>
inline void subtract_dots(const T* first, std::size_t stride, std::size_t rows, const double* x,
                          double* y) {
  Sums sums[count] = {};
  std::size_t i = 0;
  for (; i + k_sums <= rows; i += k_sums) {
    Sums factor, own;
    load_wide(x + i, factor);
    for (std::size_t k = 0; k < count; ++k) {
      load_wide(first + k * stride + i, own);
      sums[k] += own * factor;
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    double dot = (sums[k][0] + sums[k][1]) + (sums[k][2] + sums[k][3]);
    for (std::size_t rest = i; rest < rows; ++rest)
      dot += static_cast<double>(first[k * stride + rest]) * x[rest];
    y[k] -= dot;
  }
}

template <class T>
inline void subtract_transposed(const Panel<T>& l, const double* x, double* y) {
  constexpr std::size_t at_once = PLANISH_LANES < 4 ? 4 : 8;  // that registers have room for
  std::size_t k = 0;
  const auto column = [&] { return l.values + k * l.stride; };
  for (; k + at_once <= l.columns; k += at_once)
    subtract_dots<at_once>(column(), l.stride, l.rows, x, y + k);
  for (; k + k_together <= l.columns; k += k_together)
    subtract_dots<k_together>(column(), l.stride, l.rows, x, y + k);
  for (; k < l.columns; ++k)
    subtract_dots<1>(column(), l.stride, l.rows, x, y + k);
}

/// The columns of a triangle from `begin` on, up to four of them, as far down as the triangle goes.
template <class T>
inline Panel<T> block_of(const TrianglePanel<T>& l, std::size_t begin) {
  const std::size_t rows = l.size - begin;
  return {l.values + begin * (l.size + 2) - begin * begin / 2, rows,
          rows < k_together ? rows : k_together, rows};
}

/// Its rows below its own triangle.
template <class T>
inline Panel<T> below(const Panel<T>& block) {
  return {block.values + block.columns, block.rows - block.columns, block.columns, block.stride};
}

template <class T>
inline void solve_unit_lower(const TrianglePanel<T>& l, double* x) {
  for (std::size_t begin = 0; begin < l.size; begin += k_together) {
    const Panel<T> block = block_of(l, begin);
    double* own = x + begin;
    for (std::size_t k = 0; k < block.columns; ++k) {
      for (std::size_t i = k + 1; i < block.columns; ++i)
        own[i] -= static_cast<double>(block.values[k * block.stride + i]) * own[k];
    }
    combine_product<Sign::minus>(below(block), own, own + block.columns);
  }
}

template <class T>
inline void solve_unit_lower_transposed(const TrianglePanel<T>& l, double* x) {
  for (std::size_t blocks = (l.size + k_together - 1) / k_together; blocks-- > 0;) {
    const Panel<T> block = block_of(l, blocks * k_together);
    double* own = x + blocks * k_together;
    subtract_transposed(below(block), own + block.columns, own);
    for (std::size_t k = block.columns; k-- > 0;) {
      for (std::size_t i = k + 1; i < block.columns; ++i)
        own[k] -= static_cast<double>(block.values[k * block.stride + i]) * own[i];
    }
  }
}

template <class T>
PanelKernel<T> panel_kernel() {
  return {combine_product<Sign::plus, T>, subtract_transposed<T>, solve_unit_lower<T>,
          solve_unit_lower_transposed<T>};
}

inline PanelKernels panel_kernels() {
  return {panel_kernel<double>(), panel_kernel<float>()};
}

}  // namespace planish::PLANISH_ISA
