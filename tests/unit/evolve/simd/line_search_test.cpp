#define PLANISH_ISA test_lanes
#define PLANISH_LANES 2
#include "evolve/simd/line_search.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "oracle/line_solver.h"
#include "oracle/model_search.h"
#include "support/meshes.h"

namespace planish {
namespace {

/// The sum of the squares of a few wavy residuals.
struct Waves {
  double shift[3], bend[3];

  explicit Waves(meshes::Random& random) {
    for (int i = 0; i < 3; ++i)
      shift[i] = random.number(), bend[i] = random.number();
  }
  planish::LinePoint operator()(double x) const {
    planish::LinePoint f{x, 0.0, 0.0, 0.0};
    for (int i = 0; i < 3; ++i) {
      const double r = std::sin(3.0 * bend[i] * x) + shift[i] + bend[i] * x;
      const double rate = 3.0 * bend[i] * std::cos(3.0 * bend[i] * x) + bend[i];
      f.value += r * r;
      f.slope += 2.0 * r * rate;
      f.curvature += 2.0 * rate * rate;
    }
    return f;
  }
  std::vector<plain::Series> residuals() const {
    std::vector<plain::Series> series;
    for (int i = 0; i < 3; ++i)
      series.push_back({{shift[i], 4.0 * bend[i], 0.0, -4.5 * std::pow(bend[i], 3)}});
    return series;
  }
};

struct Search {
  double at[test_lanes::k_lanes], value[test_lanes::k_lanes];
  int evaluations = 0;
};

/// Searches one f in each lane.
Search search(const std::vector<Waves>& waves, double low) {
  using namespace test_lanes;
  const auto in_lanes = [&](const auto& number_of) {
    Real numbers{};
    for (int lane = 0; lane < k_lanes; ++lane)
      numbers[lane] = number_of(waves[static_cast<std::size_t>(lane)], lane);
    return numbers;
  };
  LineModel model{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto coefficient = [&](std::size_t k) {
      return in_lanes([&](const Waves& w, int) { return w.residuals()[i].c[k]; });
    };
    model.add_square(coefficient(0), coefficient(1), coefficient(2), coefficient(3));
  }
  LineSearch search(model, broadcast(low), broadcast(1.0), Mask{});
  Search result{};
  for (int i = 1; i < LineSearch::k_most_evaluations; ++i) {
    const Real place = search.next();
    if (search.done()) break;
    ++result.evaluations;
    search.tell(place, in_lanes([&](const Waves& w, int lane) { return w(place[lane]).value; }));
  }
  for (int lane = 0; lane < k_lanes; ++lane)
    result.at[lane] = search.at()[lane], result.value[lane] = search.value()[lane];
  return result;
}

TEST(LineSearch, TakesTheStepsOfThePlainSearchInEveryLane) {
  meshes::Random random(11);
  for (int trial = 0; trial < 2000; ++trial) {
    const std::vector<Waves> waves{Waves(random), Waves(random)};
    const double low = trial % 3 == 0 ? -0.5 : 0.0;
    const Search found = search(waves, low);
    for (std::size_t lane = 0; lane < waves.size(); ++lane) {
      const Waves& w = waves[lane];
      const auto plain =
          plain::search_on_line(w.residuals(), [&](double x) { return w(x).value; }, {low, 1.0});
      EXPECT_NEAR(found.at[lane], plain.at, 1e-9);
      EXPECT_NEAR(found.value[lane], plain.value, 1e-12);
    }
  }
}

TEST(LineSearch, FindsAMinimumAndNeverRises) {
  meshes::Random random(12);
  int evaluations = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const std::vector<Waves> waves{Waves(random), Waves(random)};
    const double low = trial % 3 == 0 ? -0.5 : 0.0;
    const Search found = search(waves, low);
    evaluations += found.evaluations;
    for (std::size_t lane = 0; lane < waves.size(); ++lane) {
      const Waves& w = waves[lane];
      const double x = found.at[lane];
      EXPECT_LE(found.value[lane], w(0.0).value);
      // Nothing lower within a few tolerances on either side.
      for (const double beside : {x - 0.01, x + 0.01}) {
        if (beside < low || beside > 1.0) continue;
        EXPECT_GE(w(beside).value, found.value[lane]) << trial << " at " << x;
      }
    }
  }
  EXPECT_LT(evaluations, 2000 * 5);
}

TEST(LineSearch, EvaluatesNothingWhereTheMinimumIsAtTheStart) {
  using namespace test_lanes;
  LineModel model{};  // (t - 1e-5)^2
  model.add_square(broadcast(-1e-5), broadcast(1.0), Real{}, Real{});
  LineSearch search(model, broadcast(-1.0), broadcast(1.0), Mask{});
  search.next();
  EXPECT_TRUE(search.done());
  EXPECT_EQ(search.at()[0], 0.0);
}

}  // namespace
}  // namespace planish
