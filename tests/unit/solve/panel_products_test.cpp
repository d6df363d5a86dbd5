#include "solve/panel_products.h"

#include <algorithm>
#include <cmath>
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

TEST_P(PanelProducts, AddAndSubtractTheProduct) {
  const Numbers x = random_numbers(l_.columns, 2), before = random_numbers(l_.rows + 1, 3);
  const Numbers expected = product(x, false);
  Numbers more = before, less = before;
  add_product(l_, x.data(), more.data());
  subtract_product(l_, x.data(), less.data());
  for (std::size_t i = 0; i < l_.rows; ++i) {
    EXPECT_NEAR(more[i], before[i] + expected[i], 1e-14);
    EXPECT_NEAR(less[i], before[i] - expected[i], 1e-14);
  }
  EXPECT_EQ(more[l_.rows], before[l_.rows]);
  Numbers more_by_float = before, less_by_float = before;
  add_product(narrow_, x.data(), more_by_float.data());
  subtract_product(narrow_, x.data(), less_by_float.data());
  EXPECT_EQ(more_by_float, more);
  EXPECT_EQ(less_by_float, less);
}

TEST_P(PanelProducts, SubtractTheTransposedProduct) {
  const Numbers x = random_numbers(l_.rows, 2), before = random_numbers(l_.columns + 1, 3);
  const Numbers expected = product(x, true);
  Numbers less = before;
  subtract_transposed_product(l_, x.data(), less.data());
  for (std::size_t k = 0; k < l_.columns; ++k)
    EXPECT_NEAR(less[k], before[k] - expected[k], 1e-14);
  EXPECT_EQ(less[l_.columns], before[l_.columns]);
  Numbers by_float = before;
  subtract_transposed_product(narrow_, x.data(), by_float.data());
  EXPECT_EQ(by_float, less);
}

TEST_P(PanelProducts, SolveWithTheUnitLowerTriangle) {
  const std::size_t n = l_.columns;
  const Panel<double> square{l_.values, n, n, k_stride};
  const Panel<float> narrow{narrow_.values, n, n, k_stride};
  const Numbers right = random_numbers(n, 2);
  Numbers x = right, y = right, x_by_float = right, y_by_float = right;
  solve_unit_lower(square, x.data());
  solve_unit_lower_transposed(square, y.data());
  solve_unit_lower(narrow, x_by_float.data());
  solve_unit_lower_transposed(narrow, y_by_float.data());
  EXPECT_EQ(x_by_float, x);
  EXPECT_EQ(y_by_float, y);
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
  for (const std::size_t rows : {0, 1, 2, 3, 4, 5, 7, 8, 41}) {
    for (const std::size_t columns : {0, 1, 2, 3, 4, 5, 6, 7, 8, 40})
      shapes.push_back({rows, columns});
  }
  return shapes;
}

INSTANTIATE_TEST_SUITE_P(Shapes, PanelProducts, testing::ValuesIn(shapes()));

}  // namespace
}  // namespace planish
