#include "oracle/angle_product.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

using std::numbers::pi;

double defect_of(const std::vector<double>& angles, double size = 1.0) {
  AngleProduct product;
  for (const double a : angles)
    product.add({size * std::cos(a), size * std::abs(std::sin(a))});
  return product.defect();
}

TEST(AngleProduct, OfNothingIsAFullTurn) {
  EXPECT_EQ(AngleProduct{}.defect(), 2.0 * pi);
}

TEST(AngleProduct, CountsTurns) {
  for (int corners = 1; corners <= 40; ++corners) {
    for (const double angle : {0.01, 0.7, 1.5, 2.9, 3.1}) {
      const double expected = 2.0 * pi - angle * corners;
      EXPECT_NEAR(defect_of(std::vector<double>(corners, angle)), expected, 1e-13 * corners)
          << corners << " corners of " << angle;
    }
  }
}

TEST(AngleProduct, CountsTurnsOfCornersOfExactlyZeroAndPi) {
  const Corner zero{1.0, 0.0}, straight{-1.0, 0.0}, right{0.0, 1.0};
  const auto sum = [](std::initializer_list<Corner> corners) {
    AngleProduct product;
    for (const Corner& c : corners)
      product.add(c);
    return 2.0 * pi - product.defect();
  };
  EXPECT_NEAR(sum({zero, zero}), 0.0, 1e-15);
  EXPECT_NEAR(sum({straight}), pi, 1e-15);
  EXPECT_NEAR(sum({straight, straight}), 2.0 * pi, 1e-15);
  EXPECT_NEAR(sum({straight, straight, straight}), 3.0 * pi, 1e-15);
  EXPECT_NEAR(sum({right, right, right, right, right}), 2.5 * pi, 1e-15);
  EXPECT_NEAR(sum({zero, straight, zero, straight, zero}), 2.0 * pi, 1e-15);
}

TEST(AngleProduct, KeepsTheDigitsOfASmallDefect) {
  // Four corners that miss 2 pi by 4e-13: the sum of four arctangents would lose three digits.
  const double small = 1e-13;
  AngleProduct product;
  for (int k = 0; k < 4; ++k)
    product.add({std::sin(small), std::cos(small)});
  EXPECT_NEAR(product.defect(), 4.0 * small, 1e-27);
}

TEST(AngleProduct, NeitherOverflowsNorVanishesAroundManyCorners) {
  for (const double size : {1e-150, 1e150}) {
    const double expected = 2.0 * pi - 3000 * 0.002;
    EXPECT_NEAR(defect_of(std::vector<double>(3000, 0.002), size), expected, 1e-11);
  }
}

TEST(AngleProduct, AgreesWithASumOfAnglesOnRandomStars) {
  meshes::Random random(7);
  for (int trial = 0; trial < 20'000; ++trial) {
    std::vector<double> angles;
    double sum = 0.0;
    const int corners = 3 + trial % 20;
    for (int k = 0; k < corners; ++k) {
      angles.push_back(0.5 * pi * (1.0 + random.number()));
      sum += angles.back();
    }
    ASSERT_NEAR(defect_of(angles), 2.0 * pi - sum, 1e-13) << trial;
  }
}

}  // namespace
}  // namespace planish
