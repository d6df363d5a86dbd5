#include "oracle/line_solver.h"

#include <gtest/gtest.h>

namespace planish {
namespace {

/// (x - minimum)^2 scaled, as one residual: Gauss-Newton is exact.
auto parabola(double minimum) {
  return [minimum](double x) {
    return LinePoint{x, (x - minimum) * (x - minimum), 2.0 * (x - minimum), 2.0};
  };
}

TEST(LineSolver, FindsAMinimumInside) {
  EXPECT_NEAR(minimise_on_line(parabola(0.3), {0.0, 1.0}).at, 0.3, 1e-12);
  EXPECT_NEAR(minimise_on_line(parabola(-0.7), {-1.0, 1.0}).at, -0.7, 1e-12);
}

TEST(LineSolver, StopsAtTheEndOfTheInterval) {
  EXPECT_EQ(minimise_on_line(parabola(3.0), {0.0, 1.0}).at, 1.0);
  EXPECT_EQ(minimise_on_line(parabola(-3.0), {-0.5, 1.0}).at, -0.5);
}

TEST(LineSolver, StaysWhereBothWaysLeadUp) {
  EXPECT_EQ(minimise_on_line(parabola(-0.2), {0.0, 1.0}).at, 0.0);
  EXPECT_EQ(minimise_on_line(parabola(0.0), {-1.0, 1.0}).at, 0.0);
  EXPECT_EQ(minimise_on_line(parabola(0.5), {0.0, 0.0}).at, 0.0);
}

TEST(LineSolver, NeverReturnsMoreThanItFoundAtZero) {
  // The curvature is told ten times too small, so that every step is far too long.
  const auto f = [](double x) { return LinePoint{x, (x - 0.1) * (x - 0.1), 2.0 * (x - 0.1), 0.2}; };
  const LinePoint best = minimise_on_line(f, {0.0, 1.0});
  EXPECT_LT(best.value, 0.01);
  EXPECT_NEAR(best.at, 0.1, 2e-3);
}

TEST(LineSolver, ConvergesWithoutCurvature) {
  const auto f = [](double x) { return LinePoint{x, (x - 0.4) * (x - 0.4), 2.0 * (x - 0.4), 0.0}; };
  EXPECT_NEAR(minimise_on_line(f, {0.0, 1.0}).at, 0.4, 2e-3);
}

TEST(LineSolver, CallsTheFunctionAFewTimesAtMost) {
  int calls = 0;
  const auto f = [&calls](double x) {
    ++calls;
    return LinePoint{x, std::abs(x - 0.37), x < 0.37 ? -1.0 : 1.0, 0.0};
  };
  EXPECT_NEAR(minimise_on_line(f, {0.0, 1.0}).at, 0.37, 1e-3);
  EXPECT_LE(calls, 16);
}

}  // namespace
}  // namespace planish
