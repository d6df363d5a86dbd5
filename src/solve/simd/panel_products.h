#pragma once

#include <cstddef>

#include "core/simd/isa.h"

namespace planish {

/// A dense matrix of columns of numbers, double or float, one after the other.
template <class T>
struct Panel {
  const T* values;
  std::size_t rows, columns, stride;  // stride: from column to column

  const T* column(std::size_t k) const { return values + k * stride; }
  /// @pre the part is within the panel
  Panel part(std::size_t row, std::size_t column, std::size_t row_count,
             std::size_t column_count) const {
    return {values + column * stride + row, row_count, column_count, stride};
  }
};

/// The lower triangle of a square matrix L, which has ones on its diagonal, in blocks of columns:
/// of each block the rows from its first column on, column after column. What lies on the diagonal
/// and above it there does not count.
template <class T>
struct TrianglePanel {
  const T* values;
  std::size_t size;

  static constexpr std::size_t k_block = 4;
  /// The first row that is kept of a column.
  static constexpr std::size_t first_row(std::size_t column) { return column / k_block * k_block; }
  /// Where its numbers start. That of the column behind the last one is how many there are.
  static constexpr std::size_t start(std::size_t size, std::size_t column) {
    const std::size_t first = first_row(column);
    return first * (size + k_block / 2) - first * first / 2 + (column - first) * (size - first);
  }
};

/// Products of panels L with vectors x, which do not overlap with y. Products and sums are those of
/// doubles. In what order numbers are summed follows from the shape of the panel alone, never from
/// the width of registers, so that every build and every processor give the same bits.
template <class T>
struct PanelKernel {
  /// y += L x.
  void (*add_product)(const Panel<T>& l, const double* x, double* y);
  /// y -= L^T x.
  void (*subtract_transposed_product)(const Panel<T>& l, const double* x, double* y);
  /// x := L^-1 x.
  void (*solve_unit_lower)(const TrianglePanel<T>& l, double* x);
  /// x := L^-T x.
  void (*solve_unit_lower_transposed)(const TrianglePanel<T>& l, double* x);
};

template <class T>
PanelKernel<T> panel_kernel_for(Isa isa);

/// For one set of instructions.
struct PanelKernels {
  PanelKernel<double> of_double;
  PanelKernel<float> of_float;
};

}  // namespace planish
