#include "geometry/crosses_itself.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

TEST(CrossesItself, TellsAnEightFromAnO) {
  EXPECT_FALSE(crosses_itself(std::vector<Vec2>{{0, 0}, {2, 0}, {2, 1}, {0, 1}}));
  EXPECT_TRUE(crosses_itself(std::vector<Vec2>{{0, 0}, {2, 1}, {2, 0}, {0, 1}}));
}

TEST(CrossesItself, AgreesWithTryingAllPairs) {
  meshes::Random random(9);
  const auto side = [](Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); };
  int crossing = 0;
  for (int trial = 0; trial < 400; ++trial) {
    // A wobbly ring that crosses itself now and then.
    std::vector<Vec2> polygon;
    const int n = 30;
    for (int k = 0; k < n; ++k) {
      const double angle = 2.0 * std::numbers::pi * (k + 0.8 * random.number()) / n;
      const double radius = 1.0 + 0.2 * random.number();
      polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    bool expected = false;
    for (int i = 0; i < n; ++i) {
      for (int j = i + 2; j < n; ++j) {
        const Vec2 a = polygon[i], b = polygon[i + 1], c = polygon[j], d = polygon[(j + 1) % n];
        if (i == 0 && j == n - 1) continue;
        expected = expected ||
                   (side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0);
      }
    }
    EXPECT_EQ(crosses_itself(polygon), expected) << trial;
    crossing += expected ? 1 : 0;
  }
  EXPECT_GT(crossing, 40);
  EXPECT_LT(crossing, 360);
}

TEST(SelfCrossings, AreWhereSidesMeet) {
  const std::vector<Vec2> eight = {{0, 0}, {2, 1}, {2, 0}, {0, 1}};
  const auto places = self_crossings(eight, 10);
  ASSERT_EQ(places.size(), 1U);
  EXPECT_NEAR(norm(places[0] - Vec2{1.0, 0.5}), 0.0, 1e-12);
  EXPECT_TRUE(self_crossings(eight, 0).empty());
  // A bar that two spikes cross twice each.
  const std::vector<Vec2> comb = {{0, 0}, {10, 0}, {10, 2}, {7, -1}, {4, 2}, {2, -2}, {0, 2}};
  EXPECT_EQ(self_crossings(comb, 10).size(), 4U);
  EXPECT_EQ(self_crossings(comb, 3).size(), 3U);
}

TEST(CrossesItself, TakesNearLinearTime) {
  // 200,000 sides: all pairs would be 2 * 10^10.
  std::vector<Vec2> polygon;
  for (int k = 0; k < 200'000; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / 200'000.0;
    polygon.push_back({3.0 * std::cos(angle), std::sin(angle)});
  }
  EXPECT_FALSE(crosses_itself(polygon));
  std::swap(polygon[100], polygon[150]);
  EXPECT_TRUE(crosses_itself(polygon));
}

TEST(CrossesItself, TakesNearLinearTimeWhereSidesDifferInLength) {
  // A square with a finely meshed notch: 200,000 sides in a thousandth of its width.
  std::vector<Vec2> polygon{{0, 0}, {1, 0}, {1, 1}};
  const int n = 200'000;
  for (int k = 0; k < n; ++k) {
    const double t = (k + 0.5) / n;
    polygon.push_back({0.5 - 1e-3 * t, 1.0 - 5e-4 * std::sin(std::numbers::pi * t)});
  }
  polygon.push_back({0, 1});
  EXPECT_FALSE(crosses_itself(polygon));
}

TEST(CrossesItself, DoesNotTakeASlitForACrossing) {
  EXPECT_FALSE(
      crosses_itself(std::vector<Vec2>{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 0.5}, {1, 1}, {0, 1}}));
}

}  // namespace
}  // namespace planish
