#include "draw/whole_steps.h"

#include <limits>

#include <gtest/gtest.h>

namespace planish {
namespace {

using Points = std::vector<Vec2>;

TEST(WholeSteps, RoundsAndDropsRepeatsAndWhatIsNowhere) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Points line = {{0.0, 0.0}, {0.04, 0.0}, {nan, 1.0}, {0.26, -0.24}, {1.0, infinity}};
  EXPECT_EQ(whole_steps(line, 10.0, false), (Points{{0, 0}, {3, -2}}));
}

TEST(WholeSteps, LeavesTheWayBackOfAClosedLineToTheFormat) {
  const Points line = {{0, 0}, {1, 0}, {1, 1}, {0.01, 0}, {0, 0}};
  EXPECT_EQ(whole_steps(line, 10.0, true), (Points{{0, 0}, {10, 0}, {10, 10}}));
  EXPECT_EQ(whole_steps(line, 10.0, false).size(), 4U);
  EXPECT_TRUE(whole_steps({}, 10.0, true).empty());
}

}  // namespace
}  // namespace planish
