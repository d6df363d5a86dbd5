#include "unfold/placement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

struct Size {
  double width = 0.0, height = 0.0;
};

Size size_of(const std::vector<Vec2>& points) {
  Size size;
  for (const Vec2 p : points) {
    EXPECT_GE(std::min(p.x, p.y), -1e-12);
    size = {std::max(size.width, p.x), std::max(size.height, p.y)};
  }
  return size;
}

TEST(Placement, LaysARectangleOnItsLongSide) {
  for (const double angle : {0.0, 0.3, 1.2, 2.0, 4.0}) {
    std::vector<Vec2> points;
    for (const Vec2 p : {Vec2{0, 0}, Vec2{1, 0}, Vec2{1, 3}, Vec2{0, 3}, Vec2{0, 1.5}}) {
      points.push_back({std::cos(angle) * p.x - std::sin(angle) * p.y + 7.0,
                        std::sin(angle) * p.x + std::cos(angle) * p.y - 2.0});
    }
    const Size size = size_of(place_in_smallest_box(points, points));
    EXPECT_NEAR(size.width, 3.0, 1e-12) << angle;
    EXPECT_NEAR(size.height, 1.0, 1e-12) << angle;
  }
}

TEST(Placement, FindsTheSmallestBoxAmongAllTurns) {
  meshes::Random random(5);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Vec2> points;
    for (int k = 0; k < 4 + trial; ++k)
      points.push_back({random.number(), 0.4 * random.number()});
    double least = std::numeric_limits<double>::infinity();
    for (int step = 0; step < 2000; ++step) {
      const double angle = std::numbers::pi * step / 2000.0;
      double low_x = 1e9, high_x = -1e9, low_y = 1e9, high_y = -1e9;
      for (const Vec2 p : points) {
        const double x = std::cos(angle) * p.x + std::sin(angle) * p.y;
        const double y = std::cos(angle) * p.y - std::sin(angle) * p.x;
        low_x = std::min(low_x, x), high_x = std::max(high_x, x);
        low_y = std::min(low_y, y), high_y = std::max(high_y, y);
      }
      least = std::min(least, (high_x - low_x) * (high_y - low_y));
    }
    const Size size = size_of(place_in_smallest_box(points, points));
    EXPECT_LE(size.width * size.height, least * (1.0 + 1e-9)) << trial;
    EXPECT_GE(size.width, size.height);
  }
}

TEST(Placement, TurnsWithoutMirroring) {
  const std::vector<Vec2> points{{0, 0}, {0, 5}, {-1, 5}, {-1, 0}};
  const auto placed = place_in_smallest_box(points, points);
  EXPECT_GT(cross(placed[1] - placed[0], placed[2] - placed[0]), 0.0);
}

}  // namespace
}  // namespace planish
