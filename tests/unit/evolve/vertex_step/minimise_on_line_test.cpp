#include "evolve/vertex_step/minimise_on_line.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

/// Minimises f and checks what holds for every function: positions strictly inside, no rise.
template <class F>
LineMinimum minimum_of(const F& f, Interval interval, double start) {
  int calls = 0;
  const LineFunction watched = [&](double x) {
    ++calls;
    EXPECT_GT(x, interval.low);
    EXPECT_LT(x, interval.high);
    return f(x);
  };
  const LineMinimum found = minimise_on_line(watched, interval, start);
  EXPECT_EQ(found.evaluations, calls);
  EXPECT_LE(found.evaluations, 101);
  EXPECT_LE(found.sample.value, f(start).value);
  EXPECT_EQ(found.sample.value, f(found.at).value);
  return found;
}

LineSample parabola(double x, double at) {
  return {(x - at) * (x - at), 2.0 * (x - at), 2.0};
}

TEST(TrustRegion, FindsTheMinimumOfAParabolaInside) {
  for (const double at : {0.1, 0.5, 0.9, 0.999}) {
    for (const double start : {0.001, 0.3, 0.95}) {
      const auto found = minimum_of([&](double x) { return parabola(x, at); }, {0.0, 1.0}, start);
      EXPECT_NEAR(found.at, at, 1e-9) << at << " from " << start;
      EXPECT_LE(found.evaluations, 16) << at << " from " << start;
    }
  }
}

TEST(TrustRegion, FindsMinimaOnTheBoundsFromInside) {
  // Down to the left and to the right bound, and with the minimum just outside.
  for (const double at : {-3.0, -1e-6, 0.0, 1.0, 1.0 + 1e-6, 7.0}) {
    const auto found = minimum_of([&](double x) { return parabola(x, at); }, {0.0, 1.0}, 0.4);
    EXPECT_NEAR(found.at, std::clamp(at, 0.0, 1.0), 1e-6) << at;
    EXPECT_NEAR(found.sample.value, parabola(std::clamp(at, 0.0, 1.0), at).value, 1e-9) << at;
  }
  const auto line = minimum_of(
      [](double x) {
        return LineSample{-x, -1.0, 0.0};
      },
      {-2.0, 3.0}, 0.0);
  EXPECT_NEAR(line.at, 3.0, 1e-9);
}

TEST(TrustRegion, ConvergesQuadratically) {
  // 2 cosh(3 (x - 0.7)): Newton's steps go beyond the minimum.
  const auto f = [](double x) {
    const double up = std::exp(3.0 * (x - 0.7)), down = 1.0 / up;
    return LineSample{up + down, 3.0 * (up - down), 9.0 * (up + down)};
  };
  const auto found = minimum_of(f, {0.0, 1.0}, 0.001);
  EXPECT_NEAR(found.at, 0.7, 1e-8);
  EXPECT_LE(found.evaluations, 8);
}

TEST(TrustRegion, GoesDownWhereTheFunctionBendsDown) {
  // From near a maximum at 0 to the minimum of -cos.
  const auto f = [](double x) {
    return LineSample{std::cos(4.0 * x), -4.0 * std::sin(4.0 * x), -16.0 * std::cos(4.0 * x)};
  };
  EXPECT_NEAR(minimum_of(f, {-1.0, 1.0}, 1e-3).at, 0.25 * 3.141592653589793, 1e-8);
  EXPECT_NEAR(minimum_of(f, {-1.0, 1.0}, -1e-3).at, -0.25 * 3.141592653589793, 1e-8);
}

TEST(TrustRegion, FindsAFlatMinimum) {
  const auto f = [](double x) {
    const double t = x - 0.6;
    return LineSample{1.0 + t * t * t * t, 4.0 * t * t * t, 12.0 * t * t};
  };
  const auto found = minimum_of(f, {0.0, 1.0}, 0.001);
  EXPECT_NEAR(found.sample.value, 1.0, 1e-12);
}

TEST(TrustRegion, FindsAKink) {
  const auto f = [](double x) {
    return LineSample{std::abs(x - 0.3) + 0.1 * x, x < 0.3 ? -0.9 : 1.1, 0.0};
  };
  EXPECT_NEAR(minimum_of(f, {0.0, 1.0}, 0.001).at, 0.3, 1e-6);
}

TEST(TrustRegion, DoesNotGoWhereTheFunctionIsNoNumber) {
  const double nan = std::nan("");
  const auto f = [&](double x) {
    if (x > 0.5) return LineSample{nan, nan, nan};
    return LineSample{-x, -1.0, 0.0};
  };
  const auto found = minimum_of(f, {0.0, 1.0}, 0.001);
  EXPECT_NEAR(found.at, 0.5, 1e-6);
}

TEST(TrustRegion, StaysWhereTheSlopeIsNoughtOrUphillIsTheBound) {
  const auto flat = minimum_of([](double) { return LineSample{1.0, 0.0, 0.0}; }, {0.0, 1.0}, 0.5);
  EXPECT_EQ(flat.at, 0.5);
  EXPECT_EQ(flat.evaluations, 1);
}

/// A wavy function of which all minima are known: sin(k x) + c x.
TEST(TrustRegion, EndsAtAMinimumOfEveryWave) {
  meshes::Random random(3);
  for (int trial = 0; trial < 2000; ++trial) {
    const double k = 6.0 + 5.0 * random.number(), c = 2.0 * random.number();
    const auto f = [&](double x) {
      return LineSample{std::sin(k * x) + c * x, k * std::cos(k * x) + c, -k * k * std::sin(k * x)};
    };
    const double start = 0.5 + 0.49 * random.number();
    const auto found = minimum_of(f, {0.0, 1.0}, start);
    if (std::abs(f(start).slope) < 1e-9) continue;
    const double room = found.sample.slope < 0.0 ? 1.0 - found.at : found.at;
    EXPECT_LT(room * std::abs(found.sample.slope), 1e-6) << trial;
    // And no lower place close by.
    for (const double beside : {found.at - 1e-3, found.at + 1e-3}) {
      if (beside > 0.0 && beside < 1.0) {
        EXPECT_GE(f(beside).value, found.sample.value - 1e-9) << trial;
      }
    }
  }
}

}  // namespace
}  // namespace planish
