#define PLANISH_ISA test_lanes
#define PLANISH_LANES 2
#include "core/simd/arctangent.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "oracle/angle_product.h"
#include "support/meshes.h"

namespace planish {
namespace {

using test_lanes::broadcast;

double relative_error(double found, double expected) {
  return expected == 0.0 ? std::abs(found) : std::abs(found / expected - 1.0);
}

TEST(Arctangent, ShortIsRightToFourUnitsInTheSixteenthDigit) {
  for (int i = -1000; i <= 1000; ++i) {
    const double t = k_tan_eighth * i / 1000.0;
    EXPECT_LE(relative_error(test_lanes::short_arctangent(broadcast(t))[0], std::atan(t)), 4e-16)
        << t;
  }
  for (double t = 0.3; t > 1e-300; t *= 1e-7) {
    EXPECT_LE(relative_error(test_lanes::short_arctangent(broadcast(t))[0], std::atan(t)), 4e-16)
        << t;
  }
}

TEST(Arctangent, ArgumentIsThatOfTheLibraryAllAround) {
  for (int i = 0; i < 4000; ++i) {
    const double angle = std::numbers::pi * (i - 1999.5) / 2000.0;
    for (const double size : {1e-100, 1.0, 1e100}) {
      const double re = size * std::cos(angle), im = size * std::sin(angle);
      const double found = test_lanes::argument({broadcast(re), broadcast(im)})[0];
      EXPECT_NEAR(found, std::atan2(im, re), 6e-16 * (1.0 + std::abs(angle)));
    }
  }
  EXPECT_EQ(test_lanes::argument({broadcast(1.0), broadcast(0.0)})[0], 0.0);
  EXPECT_EQ(test_lanes::argument({broadcast(-1.0), broadcast(0.0)})[0], std::numbers::pi);
  EXPECT_EQ(test_lanes::argument({broadcast(0.0), broadcast(-2.0)})[0], -std::numbers::pi / 2.0);
}

TEST(Arctangent, SumsOfCornersAreThoseOfTheAngleProduct) {
  meshes::Random random(5);
  for (int trial = 0; trial < 2000; ++trial) {
    test_lanes::AngleSum lanes;
    AngleProduct plain;
    const int corners = 3 + trial % 20;
    for (int j = 0; j < corners; ++j) {
      const double angle = std::numbers::pi * (0.5 + 0.5 * random.number());
      const double size = std::pow(10.0, 20.0 * random.number());
      const Corner c{size * std::cos(angle), size * std::abs(std::sin(angle))};
      lanes.add({broadcast(c.re), broadcast(c.im)});
      plain.add(c);
    }
    EXPECT_NEAR(lanes.defect()[0], plain.defect(), 1e-14 * corners);
  }
}

TEST(Arctangent, CornersOfExactlyPiAreCounted) {
  for (int corners = 1; corners < 9; ++corners) {
    test_lanes::AngleSum sum;
    for (int j = 0; j < corners; ++j)
      sum.add({broadcast(-2.0), broadcast(0.0)});
    EXPECT_NEAR(sum.defect()[0], (2 - corners) * std::numbers::pi, 1e-14);
  }
}

}  // namespace
}  // namespace planish
