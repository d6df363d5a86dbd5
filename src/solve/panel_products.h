#pragma once

#include <cstddef>

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

// Products and sums are those of doubles. In what order numbers are summed follows from the shape
// of the panel alone, never from the width of registers, so that every build gives the same bits.

/// y += L x. @pre x and y do not overlap
template <class T>
void add_product(const Panel<T>& l, const double* x, double* y);

/// y -= L x. @pre x and y do not overlap
template <class T>
void subtract_product(const Panel<T>& l, const double* x, double* y);

/// y -= L^T x. @pre x and y do not overlap
template <class T>
void subtract_transposed_product(const Panel<T>& l, const double* x, double* y);

/// x := L^-1 x. @pre L is square; of it what is below the diagonal counts, which is 1
template <class T>
void solve_unit_lower(const Panel<T>& l, double* x);

/// x := L^-T x. @pre as above
template <class T>
void solve_unit_lower_transposed(const Panel<T>& l, double* x);

}  // namespace planish
