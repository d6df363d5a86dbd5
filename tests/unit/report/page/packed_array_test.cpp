#include "report/page/packed_array.h"

#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "support/unpack.h"

namespace planish {
namespace {

TEST(PackedArray, HasTheBytesOfItsNumbersLowestFirst) {
  EXPECT_EQ(pages::bytes_of(packed_numbers(std::array<Index, 2>{1, 0x04030201})),
            (std::vector<unsigned char>{1, 0, 0, 0, 1, 2, 3, 4}));
  EXPECT_EQ(pages::bytes_of(packed_small_numbers(std::array<Index, 2>{65535, 258})),
            (std::vector<unsigned char>{255, 255, 2, 1}));
  EXPECT_EQ(pages::bytes_of(packed_floats(std::array{1.0, -2.5})),
            (std::vector<unsigned char>{0, 0, 128, 63, 0, 0, 32, 192}));
}

TEST(PackedArray, KeepsFloatsToTwentyFourBits) {
  const std::vector<double> values = {0.1, -1e-9, 3.25e7, 0.0};
  const auto read = pages::floats_of(packed_floats(values));
  ASSERT_EQ(read.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_NEAR(read[i], values[i], 0x1p-24 * std::abs(values[i]));
  EXPECT_TRUE(std::isnan(
      pages::floats_of(packed_floats(std::array{std::numeric_limits<double>::quiet_NaN()}))[0]));
}

TEST(PackedPoints, AreOffByHalfAStepAtMost) {
  std::vector<std::vector<Vec3>> lists(2);
  for (int i = 0; i < 1000; ++i) {
    lists[0].push_back({0.37 * i, 1000.0 - std::sqrt(i), 1e-3 * i * i});
    lists[1].push_back({-0.11 * i, 1000.0 + 0.3 * i, 5.0});
  }
  const PackedPoints packed = packed_points(std::span<const std::vector<Vec3>>(lists));
  ASSERT_EQ(packed.data.size(), 2U);
  EXPECT_DOUBLE_EQ(packed.low[0], -0.11 * 999);
  EXPECT_DOUBLE_EQ(packed.step[0], (0.37 * 999 + 0.11 * 999) / 65535.0);
  for (std::size_t list = 0; list < 2; ++list) {
    const auto places = pages::small_numbers_of(packed.data[list]);
    ASSERT_EQ(places.size(), 3 * lists[list].size());
    for (std::size_t i = 0; i < lists[list].size(); ++i) {
      const Vec3 p = lists[list][i];
      const std::array wanted = {p.x, p.y, p.z};
      for (std::size_t a = 0; a < 3; ++a) {
        const double read = packed.low[a] + packed.step[a] * places[3 * i + a];
        EXPECT_NEAR(read, wanted[a], 0.5001 * packed.step[a]);
      }
    }
  }
}

TEST(PackedPoints, ReachBothEndsAndStandWhatIsNotFinite) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<Vec2> points = {{2.0, 7.0}, {4.0, 7.0}, {infinity, 7.0}};
  const PackedPoints packed = packed_points(points);
  EXPECT_EQ(pages::small_numbers_of(packed.data.front()),
            (std::vector<unsigned>{0, 0, 65535, 0, 0, 0}));
  EXPECT_EQ(packed.step[1], 0.0);
}

}  // namespace
}  // namespace planish
