#include <algorithm>
#include <cmath>
#include <cstdio>

#include <planish/flatten/frontier.h>
#include <planish/mesh/shapes.h>
#include <planish/report/html_report.h>
#include <planish/report/json_report.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/watched_job.h"

namespace planish {
namespace {

using testing::HasSubstr;
using testing::Not;

const FrontierReport& panel_frontier() {
  static const FrontierReport report =
      frontier(Patch(make_shape("panel", 200)), "panel",
               {.limits = {.max = 0.01},
                .others = {{ClassicalLaplacian{}, {.max_sweeps = 3}},
                           {BilaplacianFairing{}, usual_stopping(BilaplacianFairing{})}}});
  return report;
}

TEST(FrontierLimits, AreTheUsualOnesBelowTheStrainOfThePatternAndThen0) {
  EXPECT_EQ(frontier_limits(0.1), (std::vector<double>{0.02, 0.01, 0.005, 0.001, 0.0}));
  EXPECT_EQ(frontier_limits(0.01), (std::vector<double>{0.005, 0.001, 0.0}));
  EXPECT_EQ(frontier_limits(0.0005), std::vector<double>{0.0});
  EXPECT_EQ(frontier_limits(0.0), std::vector<double>{0.0});
}

TEST(FrontierLimits, OfANumberFallGeometricallyFromThePatternsStrainToAThousandthAndThenTo0) {
  const std::vector<double> limits = frontier_limits(0.1, 6);
  ASSERT_EQ(limits.size(), 6U);
  EXPECT_DOUBLE_EQ(limits[4], 0.001);
  EXPECT_EQ(limits[5], 0.0);
  double before = 0.1;
  for (std::size_t i = 0; i < 5; before = limits[i++])
    EXPECT_NEAR(limits[i] / before, std::pow(0.01, 0.2), 1e-12);
}

TEST(FrontierLimits, OfANumberFallAlsoWhereThereIsLittleStrainOrNone) {
  EXPECT_NEAR(frontier_limits(0.0005, 3)[1], 0.00005, 1e-15);
  EXPECT_EQ(frontier_limits(0.0, 8), std::vector<double>{0.0});
  EXPECT_EQ(frontier_limits(0.1, 2).size(), 2U);
  EXPECT_LE(frontier_limits(30.0, 8).front(), 1.0) << "what Auto takes";
}

Candidate made_point(double strain, double deviation, double bending) {
  Candidate point;
  point.method = Auto{.limits = {.rms = 0.01}};
  point.strain = {strain, strain, strain};
  point.deviation = {deviation, deviation, deviation};
  point.fairness.bending_ratio = bending;
  return point;
}

TEST(FrontierDominated, IsWhatAnotherPointBeatsInSomethingAndIsNotBeatenByInAnything) {
  FrontierReport report;
  report.design.strain.rms = 0.1;
  report.design.fairness.bending_ratio = 1.0;
  report.curve = {made_point(0.05, 1.0, 1.1), made_point(0.06, 2.0, 1.2),
                  made_point(0.06, 2.0, 1.05), made_point(0.01, 3.0, 1.1),
                  made_point(0.01, 3.0, 1.1)};
  mark_dominated(report);
  std::vector<bool> dominated;
  for (const Candidate& point : report.curve)
    dominated.push_back(point.dominated);
  EXPECT_EQ(dominated, (std::vector<bool>{false, true, false, false, false}))
      << "less bending excuses the third; equal points do not beat each other";
}

TEST(FrontierDominated, IsWhatIsWorseThanThePatchAsDesignedAndOtherMethodsAreJudgedToo) {
  FrontierReport report;
  report.design.strain.rms = 0.1;
  report.design.fairness.bending_ratio = 1.0;
  report.curve = {made_point(0.2, 1.0, 1.5), made_point(0.05, 2.0, 1.1)};
  report.others = {made_point(0.05, 3.0, 1.1), made_point(0.0, 3.0, 9.0)};
  mark_dominated(report);
  EXPECT_TRUE(report.curve[0].dominated);
  EXPECT_FALSE(report.curve[1].dominated);
  EXPECT_TRUE(report.others[0].dominated);
  EXPECT_FALSE(report.others[1].dominated);
}

TEST(FrontierDominated, GoesByStrainAndDeviationWhereBendingIsNotKnown) {
  FrontierReport report;
  report.design.strain.rms = 0.1;
  report.curve = {made_point(0.05, 1.0, 0.0), made_point(0.06, 2.0, 0.0)};
  for (Candidate& point : report.curve)
    point.fairness.bending_ratio.reset();
  mark_dominated(report);
  EXPECT_FALSE(report.curve[0].dominated);
  EXPECT_TRUE(report.curve[1].dominated);
}

TEST(Frontier, HasAPointForEveryLimitAndMethod) {
  const FrontierReport& report = panel_frontier();
  EXPECT_EQ(report.curve.size(), frontier_limits(report.design.strain.rms).size() + 1);
  ASSERT_EQ(report.others.size(), 2U);
  EXPECT_EQ(name_of(report.others[0].method), "classical");
  EXPECT_EQ(report.others[0].sweeps, 3U);
  EXPECT_TRUE(report.failures.empty());
}

TEST(Frontier, LosesStrainAsDeviationGrows) {
  const FrontierReport report = frontier(Patch(make_shape("panel", 200)), "panel");
  EXPECT_GE(report.curve.size(), 4U);
  double deviation = 0.0, strain = report.design.strain.rms;
  for (const Candidate& point : report.curve) {
    EXPECT_GT(point.deviation.rms, deviation) << candidate_name(point);
    EXPECT_LT(point.strain.rms, strain) << candidate_name(point);
    EXPECT_FALSE(point.dominated) << candidate_name(point);
    deviation = point.deviation.rms;
    strain = point.strain.rms;
  }
  EXPECT_EQ(candidate_name(report.curve.back()), "flat");
  EXPECT_LT(report.curve.back().strain.max, 1e-3);
}

TEST(Frontier, StaysSmoothUpToFlat) {
  for (const Candidate& point : panel_frontier().curve) {
    const auto& options = std::get<Auto>(point.method);
    EXPECT_TRUE(options.prefer == Prefer::flat || point.fairness.bends_little())
        << candidate_name(point);
  }
}

TEST(Frontier, HasWhatFlattenMakesOfEveryPick) {
  const Patch panel(make_shape("panel", 200));
  for (const Candidate& point : panel_frontier().curve) {
    if (!point.preset) continue;
    const FlattenReport report = flatten(panel, "panel", preset_options(*point.preset));
    const Candidate alone = report.candidates().back();
    EXPECT_EQ(point.deviation.rms, alone.deviation.rms) << *point.preset;
    EXPECT_EQ(point.deviation.rms_over_diagonal, alone.deviation.rms_over_diagonal);
    EXPECT_EQ(point.strain.rms, alone.strain.rms);
    EXPECT_EQ(point.strain.max, alone.strain.max);
    EXPECT_EQ(point.fairness.bending_ratio, alone.fairness.bending_ratio);
    EXPECT_EQ(point.stop, alone.stop);
    EXPECT_EQ(point.sweeps, alone.sweeps);
  }
  EXPECT_EQ(panel_frontier().design.strain.rms,
            unfold_patch(panel, Unit::mm, {.least_stretch = true}).strain.rms);
}

TEST(Frontier, FindsTheFirstPointWithinTheLimit) {
  FrontierReport report;
  report.curve.resize(3);
  report.curve[0].strain.max = 0.03;
  report.curve[1].strain.max = 0.02;
  report.curve[2].strain.max = 0.01;
  EXPECT_FALSE(report.first_within_limit());
  report.limits.max = 0.02;
  EXPECT_EQ(report.first_within_limit(), 1U);
  report.limits.max = 0.001;
  EXPECT_FALSE(report.first_within_limit());
  report.curve[2].strain.p99_stretch = 0.005;
  report.limits = {.max = 0.03, .p99_stretch = 0.004};
  report.curve[0].strain.p99_stretch = 0.0041;
  EXPECT_EQ(report.first_within_limit(), 1U) << "all of several";
}

TEST(Frontier, KeepsRunsThatFailApart) {
  FrontierOptions options = {.points = 2, .others = {{ClassicalLaplacian{}, {.max_sweeps = 1}}}};
  options.constraints.weights.assign(make_shape("panel", 200).positions.size(), 1.0);
  options.constraints.weights.front() = 2.0;
  const auto report = frontier(Patch(make_shape("panel", 200)), "panel", options);
  EXPECT_TRUE(report.others.empty());
  ASSERT_EQ(report.failures.size(), 1U);
  EXPECT_EQ(report.failures[0].failure.code, "unsupported_constraint");
  EXPECT_EQ(report.curve.size(), 2U);
}

TEST(Frontier, ReportsRisingProgressAndCanBeCancelled) {
  const Patch panel(make_shape("panel", 200));
  expect_cancellable(
      [&](const Context& context) { frontier(panel, "panel", {.points = 3}, context); }, 4);
}

TEST(Frontier, RefusesWhatCannotBeDone) {
  EXPECT_THROW(frontier(Patch(make_shape("panel", 200)), "", {.points = 1}), Error);
  for (const double wrong : {-0.02, 2.0, std::nan("")})
    EXPECT_THROW(frontier(Patch(make_shape("panel", 200)), "", {.limits = {.max = wrong}}), Error)
        << wrong;
  EXPECT_THROW(frontier(Patch({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                               {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}}),
                        "closed"),
               Error);
}

TEST(Frontier, JsonHasEveryPoint) {
  const FrontierReport& report = panel_frontier();
  const auto json = nlohmann::json::parse(json_report(report));
  ASSERT_EQ(json["curve"].size(), report.curve.size());
  const Candidate& point = report.curve[3];
  const auto& options = std::get<Auto>(point.method);
  EXPECT_EQ(json["curve"][3]["options"]["max_strain"], options.limits.max);
  EXPECT_EQ(json["curve"][3]["options"]["max_rms_strain"], options.limits.rms);
  EXPECT_EQ(json["curve"].back()["options"]["prefer"], "flat");
  EXPECT_EQ(json["curve"][3]["dominated"], point.dominated);
  EXPECT_EQ(json["curve"][3]["strain"]["rms"], point.strain.rms);
  EXPECT_EQ(json["curve"][3]["deviation"]["rms_over_diagonal"], point.deviation.rms_over_diagonal);
  EXPECT_EQ(json["others"][1]["method"], "fairing");
  EXPECT_EQ(json["strain_before"]["max"], report.design.strain.max);
  EXPECT_EQ(json["limit"]["max_strain"], 0.01);
  EXPECT_EQ(json["limit"]["first_within"], report.first_within_limit());
}

TEST(Frontier, CsvHasALineForEveryPoint) {
  FrontierReport report;
  report.design.stop = StopReason::design_kept;
  report.design.strain = {1.0, 0.25, 0.75};
  report.curve.push_back({.method = Auto{.limits = {.rms = 0.25}},
                          .stop = StopReason::strain_met,
                          .sweeps = 7,
                          .seconds = 0.5,
                          .strain = {0.5, 0.125, 0.375},
                          .deviation = {1.0, 2.0, 0.0625},
                          .fairness = {.bending_ratio = 1.25, .bending_added = 0.5},
                          .dominated = true});
  report.curve.push_back({.method = Auto{.limits = {.max = 0.5}, .prefer = Prefer::flat}});
  report.others.push_back(
      {.method = ClassicalLaplacian{}, .sweeps = 10, .seconds = 0.25, .flattenable = true});
  EXPECT_EQ(frontier_csv(report),
            "method,max_strain,strain_rms,strain_p99,strain_max,deviation_rms,deviation_max,"
            "rms_over_diagonal,flattenable,bending_ratio,bending_added,smooth,sweeps,stop,"
            "seconds,max_rms_strain,prefer,dominated\n"
            "design,,0.25,0.75,1,0,0,0,0,,,0,0,design_kept,0,,,0\n"
            "auto,,0.125,0.375,0.5,1,2,0.0625,0,1.25,0.5,1,7,strain_met,0.5,0.25,smooth,1\n"
            "auto,0.5,0,0,0,0,0,0,0,,,0,0,sweep_limit,0,,flat,0\n"
            "classical,,0,0,0,0,0,0,1,,,0,10,sweep_limit,0.25,,,0\n");
}

TEST(Frontier, OfAFlattenablePatchIsTheDesignAndNoChart) {
  const auto report = frontier(Patch(make_shape("cylinder", 200)), "cylinder");
  EXPECT_TRUE(report.curve.empty());
  EXPECT_TRUE(report.failures.empty());
  EXPECT_TRUE(report.design.flattenable);
  for (const std::string& text : {frontier_svg(report), html_report(report)})
    EXPECT_THAT(text, HasSubstr("Nothing to show"));
}

TEST(Frontier, ShowsInTheChartWhereEveryPointIs) {
  FrontierReport report;
  report.design.strain = {1.0, 1.0, 1.0};
  Candidate middle, end;
  middle.strain = {0.1, 0.01, 0.1};  // largest 10 %, rms 1 %
  middle.deviation.rms_over_diagonal = 0.01;
  end.strain = {0.0, 0.0, 0.0};  // at the lower edge
  end.deviation.rms_over_diagonal = 0.02;
  report.curve = {middle, end};
  const std::string svg = frontier_svg(report);
  const std::size_t at = svg.find("<polyline class=\"line-0\" points=\"");
  ASSERT_NE(at, std::string::npos);
  double x0, y0, x1, y1, x2, y2;
  ASSERT_EQ(std::sscanf(svg.c_str() + svg.find("points=", at), "points=\"%lf,%lf %lf,%lf %lf,%lf",
                        &x0, &y0, &x1, &y1, &x2, &y2),
            6);
  EXPECT_NEAR(x1 - x0, x2 - x1, 0.02) << "the way is linear";
  EXPECT_NEAR((y1 - y0) / (y2 - y0), 2.0 / 5.0, 1e-3) << "100 %, 1 %, 0.001 %: logarithmic";
}

TEST(Frontier, DrawsTheLineThroughWhatNothingNearerBeats) {
  FrontierReport report;
  report.design.strain = {1.0, 1.0, 1.0};
  const auto point = [](double deviation, double strain) {
    Candidate made;
    made.strain = {strain, strain, strain};
    made.deviation.rms_over_diagonal = deviation;
    return made;
  };
  report.curve = {point(0.01, 0.1), point(0.02, 0.2), point(0.03, 0.01), point(0.04, 0.001)};
  report.curve.back().dominated = true;
  const std::string svg = frontier_svg(report);
  const std::size_t at = svg.find("points=", svg.find("<polyline class=\"line-0\""));
  const std::string points = svg.substr(at, svg.find("/>", at) - at);
  EXPECT_EQ(std::count(points.begin(), points.end(), ','), 3) << points;
  std::size_t dots = 0;
  for (std::size_t dot = 0; (dot = svg.find("<circle class=\"line-0\"", dot)) != std::string::npos;
       ++dot)
    ++dots;
  EXPECT_EQ(dots, 6U) << "every point has one, and the line's end another";
}

TEST(Frontier, PictureAndPageShowCurveDotsAndLimit) {
  const FrontierReport& report = panel_frontier();
  for (const std::string& text : {frontier_svg(report), html_report(report)}) {
    for (const char* part :
         {">as designed</text>", ">0.5 % rms</text>", ">flat</text>", ">auto, rms</text>",
          ">auto, largest</text>", ">classical</text>", ">fairing</text>", ">limit 1"})
      EXPECT_THAT(text, HasSubstr(part));
    EXPECT_THAT(text, Not(HasSubstr("nan")));
    EXPECT_THAT(text, Not(HasSubstr("inf,")));
  }
  EXPECT_THAT(frontier_svg(report), testing::StartsWith("<svg xmlns="));
}

}  // namespace
}  // namespace planish
