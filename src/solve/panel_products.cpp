#include "solve/panel_products.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace planish {

namespace {

constexpr std::size_t k_columns = 4;  // that are taken at once
constexpr std::size_t k_lanes = 4;    // independent sums of a column's products

using Lanes = double __attribute__((vector_size(8 * k_lanes)));

void load(Lanes& lanes, const double* from) {
  std::memcpy(&lanes, from, sizeof lanes);
}

/// y[i] = combine(y[i], sum over the columns): four columns at once, then one by one.
template <class Combine>
void for_each_row(const Panel& l, const double* __restrict x, double* __restrict y,
                  const Combine& combine) {
  std::size_t k = 0;
  for (; k + k_columns <= l.columns; k += k_columns) {
    const double *l0 = l.column(k), *l1 = l.column(k + 1), *l2 = l.column(k + 2),
                 *l3 = l.column(k + 3);
    const double x0 = x[k], x1 = x[k + 1], x2 = x[k + 2], x3 = x[k + 3];
    for (std::size_t i = 0; i < l.rows; ++i)
      y[i] = combine(y[i], (l0[i] * x0 + l1[i] * x1) + (l2[i] * x2 + l3[i] * x3));
  }
  for (; k < l.columns; ++k) {
    const double *own = l.column(k), factor = x[k];
    for (std::size_t i = 0; i < l.rows; ++i)
      y[i] = combine(y[i], own[i] * factor);
  }
}

/// Of each of so many columns the sum of its products with x.
template <std::size_t count>
std::array<double, count> dots(const Panel& l, const double* x) {
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
      dots[k] += l.column(k)[rest] * x[rest];
  }
  return dots;
}

}  // namespace

void add_product(const Panel& l, const double* x, double* y) {
  for_each_row(l, x, y, [](double a, double b) { return a + b; });
}

void subtract_product(const Panel& l, const double* x, double* y) {
  for_each_row(l, x, y, [](double a, double b) { return a - b; });
}

void subtract_transposed_product(const Panel& l, const double* x, double* y) {
  std::size_t k = 0;
  for (; k + k_columns <= l.columns; k += k_columns) {
    const auto products = dots<k_columns>(l.part(0, k, l.rows, k_columns), x);
    for (std::size_t j = 0; j < k_columns; ++j)
      y[k + j] -= products[j];
  }
  for (; k < l.columns; ++k)
    y[k] -= dots<1>(l.part(0, k, l.rows, 1), x)[0];
}

void solve_unit_lower(const Panel& l, double* x) {
  for (std::size_t begin = 0; begin < l.columns; begin += k_columns) {
    const std::size_t end = std::min(begin + k_columns, l.columns);
    for (std::size_t k = begin; k < end; ++k) {
      for (std::size_t i = k + 1; i < end; ++i)
        x[i] -= l.column(k)[i] * x[k];
    }
    subtract_product(l.part(end, begin, l.columns - end, end - begin), x + begin, x + end);
  }
}

void solve_unit_lower_transposed(const Panel& l, double* x) {
  const std::size_t blocks = (l.columns + k_columns - 1) / k_columns;
  for (std::size_t block = blocks; block-- > 0;) {
    const std::size_t begin = block * k_columns, end = std::min(begin + k_columns, l.columns);
    subtract_transposed_product(l.part(end, begin, l.columns - end, end - begin), x + end,
                                x + begin);
    for (std::size_t k = end; k-- > begin;) {
      for (std::size_t i = k + 1; i < end; ++i)
        x[k] -= l.column(k)[i] * x[i];
    }
  }
}

}  // namespace planish
