#include "report/charts/convergence_chart.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/charts/log_axis.h"

namespace planish {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<std::string> texts_of(const LogAxis& axis) {
  std::vector<std::string> texts;
  for (const Tick& tick : axis.ticks)
    texts.push_back(tick.text);
  return texts;
}

TEST(LogAxis, HasTicksThatSuitItsRange) {
  EXPECT_THAT(texts_of(log_axis(0.58, 1.0)), testing::ElementsAre("0.4", "0.6", "0.8", "1"));
  EXPECT_THAT(texts_of(log_axis(0.07, 1.0)),
              testing::ElementsAre("0.05", "0.1", "0.2", "0.5", "1"));
  EXPECT_THAT(texts_of(log_axis(2e-5, 1.0)),
              testing::ElementsAre("10⁻⁵", "10⁻⁴", "0.001", "0.01", "0.1", "1"));
}

TEST(LogAxis, HoldsItsRangeBetweenTwoToNineTicks) {
  for (double low = 0.999; low > 1e-30; low *= 0.83) {
    for (const double high : {1.0, 1.3, 47.0}) {
      const LogAxis axis = log_axis(low, high);
      EXPECT_GE(axis.ticks.size(), 2U) << low;
      EXPECT_LE(axis.ticks.size(), 9U) << low;
      EXPECT_LE(axis.low, low * (1 + 1e-6));
      EXPECT_GE(axis.high, high * (1 - 1e-6)) << low;
      EXPECT_EQ(axis.place_of(axis.low), 0.0);
      EXPECT_EQ(axis.place_of(axis.high), 1.0);
    }
  }
  EXPECT_GE(log_axis(1.0, 1.0).ticks.size(), 2U) << "also where nothing changed";
}

// The y of the last point of a line, or NaN where there is no such line.
double end_of(const std::string& svg, const std::string& css_class) {
  const std::size_t at = svg.find("<polyline class=\"" + css_class + "\"");
  if (at == std::string::npos) return std::nan("");
  const std::size_t end = svg.find("\"/>", at);
  return std::strtod(svg.c_str() + svg.rfind(',', end) + 1, nullptr);
}

const Flattenability k_before = {0.5, 0.1, 2.0};

TEST(ConvergenceChart, DrawsALevelLineWhileFiguresStay) {
  std::vector<SweepRecord> history;
  for (int i = 1; i <= 60; ++i) {
    const double share = i <= 59 ? 1.0 : 1e-9;
    history.push_back({i, share * k_before.e_max, share * k_before.e_avg, share * k_before.energy});
  }
  const std::string svg = convergence_chart(k_before, history);
  EXPECT_THAT(svg, HasSubstr("e_max 10⁻⁹"));
  history.pop_back();
  const std::string level = convergence_chart(k_before, history);
  EXPECT_THAT(level, HasSubstr("e_max 1"));
  EXPECT_THAT(level, Not(HasSubstr("nan")));
  EXPECT_THAT(level, Not(HasSubstr("inf")));
}

TEST(ConvergenceChart, DrawsEachFigureAsAShareOfItsStart) {
  const std::string svg =
      convergence_chart(k_before, {{1, 0.4, 0.05, 1.0, 9, 0.0}, {2, 0.25, 0.01, 0.02, 9, 0.0}});
  EXPECT_THAT(svg, HasSubstr(">e_max 0.50</text>"));
  EXPECT_THAT(svg, HasSubstr(">e_avg 0.10</text>"));
  EXPECT_THAT(svg, HasSubstr(">energy 0.010</text>"));
  // 0.5, 0.1 and 0.01 on a logarithmic axis: the lower two are a decade apart.
  const double decade = end_of(svg, "line-energy") - end_of(svg, "line-e-avg");
  EXPECT_NEAR(end_of(svg, "line-e-avg") - end_of(svg, "line-e-max"), decade * std::log10(5.0), 0.1);
  EXPECT_THAT(svg, HasSubstr("aria-label=\"After 2 sweeps, as a share of the start: e_max 0.50, "
                             "e_avg 0.10, energy 0.010.\""));
}

TEST(ConvergenceChart, LeavesOutAFigureThatWasZeroAndEndsALineAtZero) {
  const std::string svg =
      convergence_chart({0.5, 0.0, 2.0}, {{1, 0.25, 0.0, 1.0, 9, 0.0}, {2, 0.0, 0.0, 0.5, 9, 0.0}});
  EXPECT_THAT(svg, Not(HasSubstr("line-e-avg")));
  EXPECT_THAT(svg, HasSubstr(">e_max 0.50</text>")) << "where it was before it reached 0";
  EXPECT_THAT(svg, HasSubstr(">energy 0.25</text>"));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
}

TEST(ConvergenceChart, IsEmptyWhereThereIsNothingToDraw) {
  EXPECT_EQ(convergence_chart(k_before, {}), "");
  EXPECT_EQ(convergence_chart({}, {{1, 0.0, 0.0, 0.0, 0, 0.0}}), "");
}

TEST(ConvergenceChart, KeepsItsLabelsApart) {
  const std::string svg = convergence_chart(k_before, {{1, 0.25, 0.05, 1.0, 9, 0.0}});
  std::vector<double> places;
  for (std::size_t at = 0; (at = svg.find("text-anchor=\"start\"", at)) != std::string::npos;
       ++at) {
    places.push_back(std::strtod(svg.c_str() + svg.rfind(" y=\"", at) + 4, nullptr));
  }
  ASSERT_EQ(places.size(), 3U);
  std::sort(places.begin(), places.end());
  EXPECT_GE(places[1] - places[0], 15.9);
  EXPECT_GE(places[2] - places[1], 15.9);
  EXPECT_LE(places[2], 330.0 - 44.0 + 4.0) << "and above the numbers of the sweeps";
}

TEST(ConvergenceChart, StaysSmallWithManySweepsAndKeepsTheLast) {
  std::vector<SweepRecord> history;
  for (int sweep = 1; sweep <= 100'000; ++sweep) {
    const double share = std::exp(-1e-5 * sweep);
    history.push_back({sweep, 0.5 * share, 0.1 * share, 2.0 * share, 9, 0.0});
  }
  history.back().e_max = 0.5 * 0.123;
  const std::string svg = convergence_chart(k_before, history);
  EXPECT_LT(svg.size(), 40'000U);
  EXPECT_THAT(svg, HasSubstr(">e_max 0.12</text>"));
}

}  // namespace
}  // namespace planish
