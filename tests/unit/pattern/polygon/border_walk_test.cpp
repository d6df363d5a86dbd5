#include "pattern/polygon/border_walk.h"

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(BorderWalk, GoesRoundAndRound) {
  const std::vector<Vec2> loop{{0, 0}, {4, 0}, {4, 3}};
  const BorderWalk walk(loop);
  EXPECT_EQ(walk.length(), 12.0);
  EXPECT_EQ(walk.way_to(2), 7.0);
  EXPECT_EQ(walk.at(5.0), (Vec2{4, 1}));
  EXPECT_EQ(walk.at(0.0), (Vec2{0, 0}));
  EXPECT_NEAR(norm(walk.at(-12.0 + 5.0) - Vec2{4, 1}), 0.0, 1e-12);
  EXPECT_NEAR(norm(walk.at(-5.0) - Vec2{4, 3}), 0.0, 1e-12);
  EXPECT_NEAR(norm(walk.at(24.0 + 2.0) - Vec2{2, 0}), 0.0, 1e-12);
}

TEST(BorderWalk, StepsOverPointsThatComeTwice) {
  const std::vector<Vec2> loop{{0, 0}, {4, 0}, {4, 0}, {4, 3}};
  EXPECT_EQ(BorderWalk(loop).at(4.0), (Vec2{4, 0}));
}

}  // namespace
}  // namespace planish
