#include <algorithm>
#include <cmath>
#include <limits>

#include <planish/planish.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

double distance_to(const Polygon& line, Vec2 p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2 a = line[i], way = line[(i + 1) % line.size()] - a;
    const double share = std::clamp(dot(p - a, way) / dot(way, way), 0.0, 1.0);
    least = std::min(least, norm(p - a - share * way));
  }
  return least;
}

/// In centimetres, 30 by 20, with an rms strain of at most 1 %.
FlattenReport flat_saddle() {
  TriMesh mesh = make_shape("saddle", 800);
  FlattenOptions options;
  options.unit = Unit::cm;
  options.limits.rms = 0.01;
  return flatten(Patch(std::move(mesh)), "saddle", options);
}

PatternOptions all_lines() {
  return {.allowance = Allowance{.width = 8.0, .corners = Corners::round},
          .notches = {Notch::at_fraction(0.25), Notch::at_fraction(0.6, NotchKind::v)},
          .grain = 90.0,
          .marks = {{.vertex = 3}},
          .inner_lines = {{0, 3}},
          .label = {.name = "front"}};
}

TEST(PatternGeometry, HasTheCutLineAtTheAllowanceFromTheSeamAndNotchesOnIt) {
  const PatternGeometry pattern = pattern_geometry(flat_saddle(), all_lines());
  ASSERT_EQ(pattern.cut.size(), 1U);
  ASSERT_EQ(pattern.outline.loops.size(), 1U);
  EXPECT_TRUE(pattern.holes().empty());
  for (const Vec2 p : pattern.cut[0])
    EXPECT_NEAR(distance_to(pattern.outline.loops[0], p), 8.0, 0.006);
  ASSERT_EQ(pattern.notches.size(), 2U);
  for (const PlacedNotch& notch : pattern.notches) {
    EXPECT_LT(distance_to(pattern.cut[0], notch.at), 1e-4);
    EXPECT_NEAR(distance_to(pattern.outline.loops[0], notch.at), 8.0, 0.01);
  }
  EXPECT_EQ(pattern.grain.size(), 3U);
  EXPECT_EQ(pattern.marks.at(0), pattern.positions[3]);
  EXPECT_EQ(pattern.inner_lines.at(0), (Polygon{pattern.positions[0], pattern.positions[3]}));
  ASSERT_EQ(pattern.texts.size(), 1U);
  EXPECT_EQ(pattern.texts[0].text, "front");
}

TEST(PatternGeometry, HasTheAreaOfThePatternInSquareMillimetres) {
  const FlattenReport report = flat_saddle();
  const PatternGeometry pattern = pattern_geometry(report);
  EXPECT_EQ(pattern.cut, pattern.outline.loops) << "without an allowance";
  double on_model = 0.0;
  for (const Triangle& t : report.processed.triangles()) {
    const auto& at = report.processed.positions();
    on_model += 0.5 * norm(cross(at[t[1]] - at[t[0]], at[t[2]] - at[t[0]]));
  }
  const double expected = 100.0 * on_model * report.unfold.pattern.area_ratio;
  EXPECT_NEAR(signed_area(pattern.cut[0]), expected, 1e-9 * expected);
  EXPECT_NEAR(pattern.size.x, 10.0 * report.unfold.pattern.width, 1e-9);
}

/// 120 by 60 mm with two holes of 20 by 20 mm.
FlattenReport flat_plate() {
  FlattenOptions options;
  options.unit = Unit::cm;
  return flatten(Patch(meshes::plate_with_two_holes()), "plate", options);
}

TEST(PatternGeometry, CutsAHoleWithoutAnAllowanceThatWouldFillIt) {
  const PatternGeometry pattern =
      pattern_geometry(flat_plate(), {.allowance = Allowance{.width = 12.0}});
  ASSERT_EQ(pattern.cut.size(), 3U);
  EXPECT_NEAR(signed_area(pattern.cut[0]), 144.0 * 84.0, 1e-6);
  for (const std::size_t hole : {1, 2})
    EXPECT_NEAR(signed_area(pattern.cut[hole]), -400.0, 1e-6);
  ASSERT_EQ(pattern.left_out.size(), 2U);
  EXPECT_THAT(pattern.left_out[0], testing::HasSubstr("fills hole 1"));
  EXPECT_TRUE(
      pattern_geometry(flat_plate(), {.allowance = Allowance{.width = 6.0}}).left_out.empty());
}

TEST(PatternGeometry, LeavesOutANotchThatDoesNotFitWhileOthersDo) {
  const TriMesh wedge{{{0, 0, 0}, {10, 0, 0}, {10, 2, 0}}, {{0, 1, 2}}};
  FlattenOptions options;
  options.unit = Unit::cm;
  const FlattenReport report = flatten(Patch(wedge), "wedge", options);
  const Notch in_the_tip = Notch::on_edge(0, 1, 0.05), in_the_middle = Notch::on_edge(0, 1, 0.5);
  const PatternGeometry pattern =
      pattern_geometry(report, {.notches = {in_the_tip, in_the_middle}});
  ASSERT_EQ(pattern.notches.size(), 1U);
  ASSERT_EQ(pattern.left_out.size(), 1U);
  EXPECT_THAT(pattern.left_out[0], testing::HasSubstr("out of the piece; it is left out"));
  EXPECT_THROW(pattern_geometry(report, {.notches = {in_the_tip}}), Error);
}

TEST(PatternGeometry, IsWhereTheSheetDrawsIt) {
  const FlattenReport report = flat_saddle();
  const PatternGeometry pattern = pattern_geometry(report, all_lines());
  const Drawing sheet = pattern_sheet(report.processed.mesh(), report.unfold, pattern);
  EXPECT_EQ(sheet.title, "saddle");
  EXPECT_EQ(sheet.width, pattern.sheet_size.x);
  const auto& cut = std::get<Path>(sheet.layers.back().shapes.at(0));
  EXPECT_EQ(cut.lines, pattern.cut);
}

TEST(PatternGeometry, TakesOptionsByTheVerticesOfThePatchThatWasGiven) {
  FlattenReport report = flat_saddle();
  const PatternOptions own{.marks = {{.vertex = 3}}};
  const Vec2 at = pattern_geometry(report, own).marks.at(0);
  for (std::size_t v = 0; v < report.processed.vertex_count(); ++v)
    report.source.push_back(static_cast<Index>(2 * v));
  EXPECT_EQ(pattern_geometry(report, {.marks = {{.vertex = 6}}}).marks.at(0), at);
}

}  // namespace
}  // namespace planish
