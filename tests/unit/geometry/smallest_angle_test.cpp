#include "geometry/smallest_angle.h"

#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(SmallestAngle, IsThatOppositeTheShortestSide) {
  EXPECT_NEAR(smallest_angle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), std::numbers::pi / 4, 1e-15);
  EXPECT_NEAR(smallest_angle({0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}), std::numbers::pi / 3,
              1e-15);
  EXPECT_EQ(smallest_angle({0, 0, 0}, {1, 0, 0}, {2, 0, 0}), 0.0);
}

TEST(SmallestAngle, IsComparedWithABoundAsByItsValue) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1.0, 1.0);
  const auto point = [&] {
    return Vec3{coordinate(random), coordinate(random), coordinate(random)};
  };
  int smaller = 0;
  for (int k = 0; k < 3000; ++k) {
    const Vec3 p = point(), q = point(), r = point();
    const double angle = smallest_angle(p, q, r);
    for (const double bound : {0.0, 0.3, angle, std::nextafter(angle, 0.0),
                               std::nextafter(angle, 2.0), angle * (1.0 + 1e-10)}) {
      const bool expected = angle >= bound;
      EXPECT_EQ(has_smallest_angle_from(bound, std::cos(bound), p, q, r), expected) << angle;
      smaller += expected ? 0 : 1;
    }
  }
  EXPECT_GT(smaller, 3000);
  const Vec3 same = {1, 2, 3};
  EXPECT_FALSE(has_smallest_angle_from(0.1, std::cos(0.1), same, same, same));
}

}  // namespace
}  // namespace planish
