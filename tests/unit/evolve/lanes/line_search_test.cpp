#define PLANISH_ISA test_lanes
#define PLANISH_LANES 2
#include "evolve/lanes/line_search.h"

#include <cmath>

#include <gtest/gtest.h>

#include "oracle/line_solver.h"
#include "support/meshes.h"

namespace planish {
namespace {

/// The sum of the squares of a few wavy residuals, with slope and Gauss-Newton curvature.
struct Waves {
  double shift[3], bend[3];
  LinePoint operator()(double x) const {
    LinePoint f{x, 0.0, 0.0, 0.0};
    for (int i = 0; i < 3; ++i) {
      const double r = std::sin(3.0 * bend[i] * x) + shift[i] + bend[i] * x;
      const double rate = 3.0 * bend[i] * std::cos(3.0 * bend[i] * x) + bend[i];
      f.value += r * r;
      f.slope += 2.0 * r * rate;
      f.curvature += 2.0 * rate * rate;
    }
    return f;
  }
};

TEST(LineSearch, TakesTheStepsOfThePlainSolverInEveryLane) {
  using namespace test_lanes;
  meshes::Random random(11);
  for (int trial = 0; trial < 2000; ++trial) {
    Waves waves[k_lanes];
    Real value{}, slope{}, curvature{};
    const auto look = [&](const Real& place) {
      for (int lane = 0; lane < k_lanes; ++lane) {
        const planish::LinePoint f = waves[lane](place[lane]);
        value[lane] = f.value, slope[lane] = f.slope, curvature[lane] = f.curvature;
      }
    };
    for (Waves& w : waves) {
      for (int i = 0; i < 3; ++i)
        w.shift[i] = random.number(), w.bend[i] = random.number();
    }
    const double low = trial % 3 == 0 ? -0.5 : 0.0;
    look(Real{});
    LineSearch search(value, slope, curvature, all(low), all(1.0), Mask{});
    for (int i = 1; i < LineSearch::k_most_evaluations; ++i) {
      const Real place = search.next();
      if (search.done()) break;
      look(place);
      search.tell(place, value, slope, curvature);
    }
    for (int lane = 0; lane < k_lanes; ++lane) {
      const planish::LinePoint plain = minimise_on_line(waves[lane], {low, 1.0});
      EXPECT_EQ(search.at()[lane], plain.at);
      EXPECT_EQ(search.value()[lane], plain.value);
    }
  }
}

}  // namespace
}  // namespace planish
