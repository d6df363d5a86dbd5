#include "solve/panel_products.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace planish {

namespace {

constexpr std::size_t k_columns = 4;  // that are taken at once
constexpr std::size_t k_lanes = 4;    // independent sums of a column's products

using Lanes = double __attribute__((vector_size(8 * k_lanes)));

double wide(double x) {
  return x;
}

double wide(float x) {
  return static_cast<double>(x);
}

void load(Lanes& lanes, const double* from) {
  std::memcpy(&lanes, from, sizeof lanes);
}

void load(Lanes& lanes, const float* from) {
  float __attribute__((vector_size(4 * k_lanes))) narrow;
  std::memcpy(&narrow, from, sizeof narrow);
  lanes = __builtin_convertvector(narrow, Lanes);
}

/// y[i] = combine(y[i], sum over the columns): four columns at once, then one by one.
template <class T, class Combine>
void for_each_row(const Panel<T>& l, const double* __restrict x, double* __restrict y,
                  const Combine& combine) {
  std::size_t k = 0;
  for (; k + k_columns <= l.columns; k += k_columns) {
    const T *l0 = l.column(k), *l1 = l.column(k + 1), *l2 = l.column(k + 2), *l3 = l.column(k + 3);
    const double x0 = x[k], x1 = x[k + 1], x2 = x[k + 2], x3 = x[k + 3];
    for (std::size_t i = 0; i < l.rows; ++i)
      y[i] = combine(y[i],
                     (wide(l0[i]) * x0 + wide(l1[i]) * x1) + (wide(l2[i]) * x2 + wide(l3[i]) * x3));
  }
  for (; k < l.columns; ++k) {
    const T* own = l.column(k);
    const double factor = x[k];
    for (std::size_t i = 0; i < l.rows; ++i)
      y[i] = combine(y[i], wide(own[i]) * factor);
  }
}

/// Of each of so many columns the sum of its products with x.
template <std::size_t count, class T>
std::array<double, count> dots(const Panel<T>& l, const double* x) {
  Lanes sums[count] = {};
  std::size_t i = 0;
  for (; i + k_lanes <= l.rows; i += k_lanes) {
    Lanes factor;
    load(factor, x + i);
    for (std::size_t k = 0; k < count; ++k) {
      Lanes own;
      load(own, l.column(k) + i);
      sums[k] += own * factor;
    }
  }
  std::array<double, count> dots;
  for (std::size_t k = 0; k < count; ++k) {
    dots[k] = (sums[k][0] + sums[k][1]) + (sums[k][2] + sums[k][3]);
    for (std::size_t rest = i; rest < l.rows; ++rest)
      dots[k] += wide(l.column(k)[rest]) * x[rest];
  }
  return dots;
}

}  // namespace

template <class T>
void add_product(const Panel<T>& l, const double* x, double* y) {
  for_each_row(l, x, y, [](double a, double b) { return a + b; });
}

template <class T>
void subtract_product(const Panel<T>& l, const double* x, double* y) {
  for_each_row(l, x, y, [](double a, double b) { return a - b; });
}

template <class T>
void subtract_transposed_product(const Panel<T>& l, const double* x, double* y) {
  std::size_t k = 0;
  for (; k + k_columns <= l.columns; k += k_columns) {
    const auto products = dots<k_columns>(l.part(0, k, l.rows, k_columns), x);
    for (std::size_t j = 0; j < k_columns; ++j)
      y[k + j] -= products[j];
  }
  for (; k < l.columns; ++k)
    y[k] -= dots<1>(l.part(0, k, l.rows, 1), x)[0];
}

template <class T>
void solve_unit_lower(const Panel<T>& l, double* x) {
  for (std::size_t begin = 0; begin < l.columns; begin += k_columns) {
    const std::size_t end = std::min(begin + k_columns, l.columns);
    for (std::size_t k = begin; k < end; ++k) {
      for (std::size_t i = k + 1; i < end; ++i)
        x[i] -= wide(l.column(k)[i]) * x[k];
    }
    subtract_product(l.part(end, begin, l.columns - end, end - begin), x + begin, x + end);
  }
}

template <class T>
void solve_unit_lower_transposed(const Panel<T>& l, double* x) {
  const std::size_t blocks = (l.columns + k_columns - 1) / k_columns;
  for (std::size_t block = blocks; block-- > 0;) {
    const std::size_t begin = block * k_columns, end = std::min(begin + k_columns, l.columns);
    subtract_transposed_product(l.part(end, begin, l.columns - end, end - begin), x + end,
                                x + begin);
    for (std::size_t k = end; k-- > begin;) {
      for (std::size_t i = k + 1; i < end; ++i)
        x[k] -= wide(l.column(k)[i]) * x[i];
    }
  }
}

template void add_product(const Panel<double>&, const double*, double*);
template void subtract_product(const Panel<double>&, const double*, double*);
template void subtract_transposed_product(const Panel<double>&, const double*, double*);
template void solve_unit_lower(const Panel<double>&, double*);
template void solve_unit_lower_transposed(const Panel<double>&, double*);
template void add_product(const Panel<float>&, const double*, double*);
template void subtract_product(const Panel<float>&, const double*, double*);
template void subtract_transposed_product(const Panel<float>&, const double*, double*);
template void solve_unit_lower(const Panel<float>&, double*);
template void solve_unit_lower_transposed(const Panel<float>&, double*);

}  // namespace planish
