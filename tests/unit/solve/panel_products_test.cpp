#include "solve/simd/panel_products.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace planish {
namespace {

using Numbers = std::vector<double>;

Numbers random_numbers(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  Numbers numbers;  // that a float holds too
  for (std::size_t i = 0; i < count; ++i)
    numbers.push_back(static_cast<double>(static_cast<float>(number(random))));
  return numbers;
}

/// The numbers of the triangle of a square panel; NaN where they do not count.
template <class T>
std::vector<T> kept_of_triangle(const Panel<T>& square) {
  std::vector<T> kept(TrianglePanel<T>::start(square.columns, square.columns),
                      std::numeric_limits<T>::quiet_NaN());
  for (std::size_t k = 0; k < square.columns; ++k) {
    const std::size_t start =
        TrianglePanel<T>::start(square.columns, k) - TrianglePanel<T>::first_row(k);
    for (std::size_t i = k + 1; i < square.columns; ++i)
      kept[start + i] = square.column(k)[i];
  }
  return kept;
}

struct Shape {
  std::size_t rows, columns;
};

/// Every remainder of rows and columns, and none of either.
class PanelProducts : public testing::TestWithParam<Shape> {
 protected:
  static constexpr std::size_t k_stride = 43;

  Numbers values_ = random_numbers(k_stride * 41, 1);
  std::vector<float> narrow_values_ = std::vector<float>(values_.begin(), values_.end());
  Panel<double> l_{values_.data() + 1, GetParam().rows, GetParam().columns, k_stride};
  Panel<float> narrow_{narrow_values_.data() + 1, l_.rows, l_.columns, k_stride};

  PanelKernel<double> kernel_ = panel_kernel_for<double>(Isa::baseline);

  /// Calls visit(kernel, panel) for every set of instructions, with the numbers as doubles and as
  /// floats: all are to give the same bits.
  template <class Visit>
  void for_all_kernels(const Visit& visit) const {
    for (const Isa isa : available_isas()) {
      visit(panel_kernel_for<double>(isa), l_);
      visit(panel_kernel_for<float>(isa), narrow_);
    }
  }

  /// L x, or L^T x, by the formula.
  Numbers product(const Numbers& x, bool transposed) const {
    Numbers y(transposed ? l_.columns : l_.rows, 0.0);
    for (std::size_t i = 0; i < l_.rows; ++i) {
      for (std::size_t k = 0; k < l_.columns; ++k)
        y[transposed ? k : i] += l_.column(k)[i] * x[transposed ? i : k];
    }
    return y;
  }
};

TEST_P(PanelProducts, AddTheProduct) {
  const Numbers x = random_numbers(l_.columns, 2), before = random_numbers(l_.rows + 1, 3);
  const Numbers expected = product(x, false);
  Numbers sum = before;
  kernel_.add_product(l_, x.data(), sum.data());
  for (std::size_t i = 0; i < l_.rows; ++i)
    EXPECT_NEAR(sum[i], before[i] + expected[i], 1e-14);
  EXPECT_EQ(sum[l_.rows], before[l_.rows]);
  for_all_kernels([&](const auto& kernel, const auto& l) {
    Numbers again = before;
    kernel.add_product(l, x.data(), again.data());
    EXPECT_EQ(again, sum);
  });
}

TEST_P(PanelProducts, SubtractTheTransposedProduct) {
  const Numbers x = random_numbers(l_.rows, 2), before = random_numbers(l_.columns + 1, 3);
  const Numbers expected = product(x, true);
  Numbers less = before;
  kernel_.subtract_transposed_product(l_, x.data(), less.data());
  for (std::size_t k = 0; k < l_.columns; ++k)
    EXPECT_NEAR(less[k], before[k] - expected[k], 1e-14);
  EXPECT_EQ(less[l_.columns], before[l_.columns]);
  for_all_kernels([&](const auto& kernel, const auto& l) {
    Numbers again = before;
    kernel.subtract_transposed_product(l, x.data(), again.data());
    EXPECT_EQ(again, less);
  });
}

TEST_P(PanelProducts, SolveWithTheUnitLowerTriangle) {
  const std::size_t n = l_.columns;
  const Panel<double> square = l_.part(0, 0, n, n);
  const Numbers right = random_numbers(n, 2), kept = kept_of_triangle(square);
  Numbers x = right, y = right;
  kernel_.solve_unit_lower({kept.data(), n}, x.data());
  kernel_.solve_unit_lower_transposed({kept.data(), n}, y.data());
  for_all_kernels([&](const auto& kernel, const auto& l) {
    const auto again = kept_of_triangle(l.part(0, 0, n, n));
    Numbers x_again = right, y_again = right;
    kernel.solve_unit_lower({again.data(), n}, x_again.data());
    kernel.solve_unit_lower_transposed({again.data(), n}, y_again.data());
    EXPECT_EQ(x_again, x);
    EXPECT_EQ(y_again, y);
  });
  double size_x = 1.0, size_y = 1.0;  // of the terms, by which rounding goes
  for (std::size_t i = 0; i < n; ++i) {
    size_x = std::max(size_x, std::abs(x[i]));
    size_y = std::max(size_y, std::abs(y[i]));
  }
  for (std::size_t i = 0; i < n; ++i) {
    double image = x[i], transposed = y[i];
    for (std::size_t k = 0; k < i; ++k)
      image += square.column(k)[i] * x[k];
    for (std::size_t k = i + 1; k < n; ++k)
      transposed += square.column(i)[k] * y[k];
    EXPECT_NEAR(image, right[i], 1e-14 * size_x);
    EXPECT_NEAR(transposed, right[i], 1e-14 * size_y);
  }
}

std::vector<Shape> shapes() {
  std::vector<Shape> shapes;
  for (const std::size_t rows : {0, 1, 2, 3, 4, 5, 7, 8, 9, 15, 17, 41}) {
    for (const std::size_t columns : {0, 1, 2, 3, 4, 5, 6, 7, 8, 13, 40})
      shapes.push_back({rows, columns});
  }
  return shapes;
}

INSTANTIATE_TEST_SUITE_P(Shapes, PanelProducts, testing::ValuesIn(shapes()));

}  // namespace
}  // namespace planish
