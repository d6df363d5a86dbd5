#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include <planish/core/error.h>
#include <planish/pattern/allowance.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oracle/outline_distance.h"

namespace planish {
namespace {

using testing::HasSubstr;

PieceOutline rectangle(double width, double height) {
  return {"sleeve", {{{0, 0}, {width, 0}, {width, height}, {0, height}}}};
}

PieceOutline square_with_hole(double half_hole) {
  PieceOutline outline = rectangle(100.0, 100.0);
  outline.loops.push_back({{50 - half_hole, 50 - half_hole},
                           {50 - half_hole, 50 + half_hole},
                           {50 + half_hole, 50 + half_hole},
                           {50 + half_hole, 50 - half_hole}});
  return outline;
}

/// A ring of `count` corners that zigzags by 1 mm about a circle.
PieceOutline jagged_disk(int count) {
  PieceOutline outline{"disk", {{}}};
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / count;
    const double radius = k % 2 == 0 ? 100.0 : 99.0;
    outline.loops[0].push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return outline;
}

Error error_of(const PieceOutline& outline, const Allowance& allowance) {
  try {
    offset_outline(outline, allowance);
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no error";
  return {ErrorCode::file_not_found, ""};
}

double area_of(const std::vector<Polygon>& loops) {
  double area = 0.0;
  for (const Polygon& loop : loops)
    area += signed_area(loop);
  return area;
}

TEST(OffsetOutline, OfARectangleHasTheAreaThatItsCornersSay) {
  const double inside = 300.0 * 200.0, strips = 2.0 * 10.0 * (300.0 + 200.0);
  const auto area = [](Corners corners) {
    return area_of(offset_outline(rectangle(300.0, 200.0), {.corners = corners}));
  };
  EXPECT_NEAR(area(Corners::mitre), inside + strips + 4.0 * 100.0, 1e-2);
  EXPECT_NEAR(area(Corners::round), inside + strips + 100.0 * std::numbers::pi, 0.4);
  // A right angle squared: the mitre without its tip, 10 (sqrt 2 - 1) high and twice as wide.
  const double tip = 100.0 * std::pow(std::numbers::sqrt2 - 1.0, 2);
  EXPECT_NEAR(area(Corners::square), inside + strips + 4.0 * (100.0 - tip), 1e-2);
}

TEST(OffsetOutline, KeepsItsDistanceWhereTheOutlineIsHollow) {
  const PieceOutline bay{
      "bay", {{{0, 0}, {90, 0}, {90, 60}, {60, 60}, {60, 25}, {30, 25}, {30, 60}, {0, 60}}}};
  for (const double width : {3.0, 10.0, 14.9}) {
    const auto cut = offset_outline(bay, {.width = width, .corners = Corners::round});
    const auto range = oracle::distances(cut, bay.loops);
    EXPECT_NEAR(range.least, width, 0.0051) << width;
    EXPECT_NEAR(range.most, width, 0.0001) << width;
    EXPECT_EQ(cut.size(), 1U);
  }
  EXPECT_NEAR(area_of(offset_outline(bay, {.width = 15.1})), 120.2 * 90.2, 0.1)
      << "the bay is filled";
}

TEST(OffsetOutline, CutsOutWhatABayEnclosesThatItsAllowanceCloses) {
  const PieceOutline flask{"flask",
                           {{{0, 0},
                             {100, 0},
                             {100, 100},
                             {55, 100},
                             {55, 80},
                             {80, 80},
                             {80, 20},
                             {20, 20},
                             {20, 80},
                             {45, 80},
                             {45, 100},
                             {0, 100}}}};
  const auto cut = offset_outline(flask, {.width = 8.0});
  ASSERT_EQ(cut.size(), 2U);
  EXPECT_GT(signed_area(cut[0]), 0.0);
  EXPECT_NEAR(signed_area(cut[1]), -44.0 * 44.0, 0.1);
}

TEST(OffsetOutline, RoundsTheJagsOfAFineBorder) {
  const PieceOutline disk = jagged_disk(800);
  for (const Corners corners : {Corners::mitre, Corners::square, Corners::round}) {
    const auto cut = offset_outline(disk, {.width = 10.0, .corners = corners});
    ASSERT_EQ(cut.size(), 1U);
    const auto range = oracle::distances(cut, disk.loops);
    EXPECT_NEAR(range.least, 10.0, 0.006);
    EXPECT_NEAR(range.most, 10.0, 0.001);
    EXPECT_FALSE(oracle::any_cross(cut));
  }
}

TEST(OffsetOutline, SquaresMitresBeyondTheLimit) {
  const PieceOutline spike{"spike", {{{0, 0}, {100, -10}, {100, 10}}}};  // 11.4 degrees at the tip
  const auto reach = [&](Allowance allowance) {
    return oracle::distances(offset_outline(spike, allowance), spike.loops).most;
  };
  const double mitre = 1.0 / std::sin(std::atan(0.1));
  EXPECT_NEAR(reach({.width = 5.0, .mitre_limit = 11.0}), 5.0 * mitre, 1e-3);
  EXPECT_LT(reach({.width = 5.0, .mitre_limit = 10.0}), 5.0 * 1.5) << "as the wide corners";
}

TEST(OffsetOutline, MakesOneCornerWhereAShortEdgeOrTwoCutItOff) {
  // The lower right corner of 100 x 50 mm is cut off by one edge, the upper right one by two.
  PieceOutline outline = rectangle(100.0, 50.0);
  outline.loops[0] = {{0, 0}, {98, 0}, {100, 2}, {100, 49}, {99.5, 49.7}, {98, 50}, {0, 50}};
  const double full = 120.0 * 70.0;
  const auto mitred = offset_outline(outline, {.width = 10.0});
  ASSERT_EQ(mitred.size(), 1U);
  EXPECT_NEAR(area_of(mitred), full, 0.01) << "as without what is cut off";
  const auto round = offset_outline(outline, {.width = 10.0, .corners = Corners::round});
  EXPECT_LT(area_of(round), full - 60.0);
  // Of a wedge of 52 degrees the tip would be farther off than mitres may be.
  const double half = 26.0 * std::numbers::pi / 180.0;
  const auto at = [&](double way, double side) {
    return Vec2{100.0 - way * std::cos(half), side * way * std::sin(half)};
  };
  const PieceOutline wedge{"wedge",
                           {{at(100.0, -1.0), at(5.6, -1.0), at(5.6, 1.0), at(100.0, 1.0)}}};
  for (const Polygon& loop : offset_outline(wedge, {.width = 10.0})) {
    for (const Vec2 p : loop)
      EXPECT_LE(p.x, at(5.6, 1.0).x + 25.0);
  }
  // A long edge is a side of its own.
  outline.loops[0] = {{0, 0}, {90, 0}, {100, 10}, {100, 50}, {0, 50}};
  EXPECT_LT(area_of(offset_outline(outline, {.width = 10.0})), full - 30.0);
}

TEST(OffsetOutline, LeavesNoNotchInACornerBesideWhichASideBends) {
  // The corner of a shoe's upper: beside it the sides bend by 6 degrees and by less than one.
  const PieceOutline outline{"vamp",
                             {{{182.4354, 36.0599},
                               {189.6485, 42.2976},
                               {192.1655, 44.5069},
                               {194.7074, 47.2665},
                               {191.2047, 49.1935},
                               {189.2980, 50.2185},
                               {182.3610, 53.8062}}}};
  const Polygon cut = offset_outline(outline, {.width = 8.0}).at(0);
  for (std::size_t i = 0; i < cut.size(); ++i) {
    const Vec2 before = cut[(i + cut.size() - 1) % cut.size()];
    const Vec2 after = cut[(i + 1) % cut.size()];
    EXPECT_GT(cross(cut[i] - before, after - cut[i]), -1e-3) << cut[i].x << " " << cut[i].y;
  }
}

TEST(OffsetOutline, MayHaveAWidthForEachEdge) {
  const PieceOutline piece = rectangle(300.0, 200.0);
  const auto cut = offset_outline(piece, {.edge_widths = {{40.0, 10.0, 0.0, 10.0}}});
  EXPECT_NEAR(area_of(cut), 320.0 * 240.0, 0.1) << "a hem below, a fold above";
  EXPECT_THAT(error_of(piece, {.edge_widths = {{40.0, 10.0, -1.0, 10.0}}}).what(),
              HasSubstr("of edge 2 is -1 mm"));
  EXPECT_EQ(error_of(piece, {.edge_widths = {{0.0, 0.0, 0.0, 0.0}}}).code(),
            ErrorCode::option_out_of_range);
  EXPECT_EQ(error_of(piece, {.edge_widths = {{10.0}}}).code(), ErrorCode::option_out_of_range);
}

TEST(OffsetOutline, MakesHolesSmallerIfAsked) {
  const PieceOutline piece = square_with_hole(20.0);
  EXPECT_NEAR(area_of(offset_outline(piece, {.width = 10.0})), 120.0 * 120.0 - 20.0 * 20.0, 1e-2);
  EXPECT_NEAR(area_of(offset_outline(piece, {.width = 10.0, .holes = false})),
              120.0 * 120.0 - 40.0 * 40.0, 1e-2);
}

TEST(OffsetOutline, RefusesToFillAHole) {
  const Error error = error_of(square_with_hole(9.0), {.width = 10.0});
  EXPECT_EQ(error.code(), ErrorCode::allowance_too_wide);
  EXPECT_THAT(error.message(), HasSubstr("piece \"sleeve\""));
  EXPECT_THAT(error.message(), HasSubstr("hole 1, around (50, 50) mm"));
  EXPECT_NO_THROW(offset_outline(square_with_hole(9.0), {.width = 10.0, .holes = false}));
}

TEST(OffsetOutline, RefusesWidthsThatMakeNoSense) {
  for (const double width : {0.0, -1.0, 301.0, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity()}) {
    const Error error = error_of(rectangle(300.0, 200.0), {.width = width});
    EXPECT_EQ(error.code(), ErrorCode::option_out_of_range) << width;
    EXPECT_THAT(error.message(), HasSubstr("piece \"sleeve\"")) << width;
  }
}

TEST(OffsetOutline, RefusesWidthsOfHundredsOfDigitsInFewWords) {
  EXPECT_LT(error_of(rectangle(300.0, 200.0), {.width = 1e300}).message().size(), 200U);
  EXPECT_LT(error_of(rectangle(1e300, 2e299), {.width = 1e301}).message().size(), 200U);
}

TEST(OffsetOutline, RefusesOutlinesWithoutAnOutside) {
  const PieceOutline eight{"eight", {{{0, 0}, {200, 100}, {200, 0}, {0, 101}}}};
  EXPECT_EQ(error_of(eight, {.width = 1.0}).code(), ErrorCode::overlapping_outline);
  PieceOutline backwards = rectangle(30.0, 20.0);
  std::reverse(backwards.loops[0].begin(), backwards.loops[0].end());
  EXPECT_EQ(error_of(backwards, {.width = 1.0}).code(), ErrorCode::overlapping_outline);
}

TEST(OffsetOutline, GoesAroundASlitAndPointsThatComeTwice) {
  const PieceOutline slit{
      "slit", {{{0, 0}, {40, 0}, {40, 0}, {40, 30}, {20, 30}, {20, 10}, {20, 30}, {0, 30}}}};
  const auto cut = offset_outline(slit, {.width = 5.0});
  ASSERT_EQ(cut.size(), 1U);
  EXPECT_NEAR(signed_area(cut[0]), 50.0 * 40.0, 0.01);
}

/// Half of a piece: its fold runs up along x = 0, its other points come after the fold's upper end.
struct Half {
  std::string name;
  Polygon points;

  std::vector<Polygon> cut(Allowance allowance) const {
    PieceOutline outline{name, {points}};
    allowance.edge_widths = {std::vector<double>(points.size(), allowance.width)};
    allowance.edge_widths[0].back() = 0.0;
    allowance.folds = {std::vector<unsigned char>(points.size(), 0)};
    allowance.folds[0].back() = 1;
    return offset_outline(outline, allowance);
  }

  /// The cut line of the whole, which has no fold.
  std::vector<Polygon> opened_cut(const Allowance& allowance) const {
    Polygon whole = points;
    for (std::size_t i = points.size() - 1; i-- > 1;)
      whole.push_back({-points[i].x, points[i].y});
    return offset_outline({name, {whole}}, allowance);
  }
};

/// From the lower end of the fold, counter-clockwise, to its upper end.
std::vector<Half> halves() {
  std::vector<Half> some;
  for (const double lean : {-35.0, -10.0, -2.0, 0.0, 2.0, 10.0, 35.0, 60.0}) {
    const double slope = std::tan(lean * std::numbers::pi / 180.0);
    some.push_back({"leaning by " + std::to_string(lean),
                    {{0, 0}, {100, 100 * slope}, {100, 250}, {0, 250 + 100 * slope}}});
  }
  // A neckline of short chords, of which several are within an allowance of the fold.
  Half neck{"neckline", {{0, 0}, {150, 0}, {150, 200}, {60, 210}}};
  for (int i = 1; i <= 30; ++i) {
    const double angle = i * std::numbers::pi / 60.0;
    neck.points.push_back({60 * std::cos(angle), 210 - 90 * std::sin(angle)});
  }
  neck.points.back().x = 0.0;
  some.push_back(neck);
  Half deep{"deep neckline", {{0, 0}, {150, 0}, {150, 200}, {60, 210}}};
  for (int i = 1; i <= 30; ++i)
    deep.points.push_back({60.0 - 2.0 * i, 210 - 4.0 * i - 0.05 * i * i});
  some.push_back(deep);
  return some;
}

TEST(OffsetOutline, GoesIntoASlitWithoutAGapWhoseSidesHaveNoAllowance) {
  for (const double lean : {0.0, 7.0}) {
    const PieceOutline plate{"plate",
                             {{{0, 0},
                               {100, 0},
                               {100 + lean / 2, 30},
                               {100 + lean, 60},
                               {100 + lean / 2, 30},
                               {100, 0},
                               {200, 0},
                               {200, 100},
                               {0, 100}}}};
    const Allowance allowance{.width = 10.0, .edge_widths = {{10, 0, 0, 0, 0, 10, 10, 10, 10}}};
    const auto cut = offset_outline(plate, allowance);
    ASSERT_EQ(cut.size(), 1U) << "open through the allowance";
    double length = 0.0;
    for (std::size_t i = 0; i < cut[0].size(); ++i)
      length += norm(cut[0][(i + 1) % cut[0].size()] - cut[0][i]);
    EXPECT_NEAR(length, 2.0 * (220.0 + 120.0) + 2.0 * 70.0 / 60.0 * std::hypot(60.0, lean), 1e-3);
    EXPECT_NEAR(signed_area(cut[0]), 220.0 * 120.0, 0.01);
  }
}

TEST(OffsetOutline, IsHalfOfThatOfTheWholeBesideAFold) {
  for (const Half& half : halves()) {
    for (const Corners corners : {Corners::mitre, Corners::square, Corners::round}) {
      for (const double width : {5.0, 12.0}) {
        SCOPED_TRACE(half.name + ", " + std::string(to_string(corners)) + ", " +
                     std::to_string(width));
        const Allowance allowance{.width = width, .corners = corners};
        const auto cut = half.cut(allowance), whole = half.opened_cut(allowance);
        ASSERT_EQ(cut.size(), 1U);
        ASSERT_EQ(whole.size(), 1U);
        for (const Vec2 p : cut[0])
          EXPECT_GE(p.x, -2e-5) << "nothing is beyond the fold";
        EXPECT_NEAR(2.0 * signed_area(cut[0]), signed_area(whole[0]), 0.05);
        EXPECT_LT(oracle::distances(cut, {half.points}).most, 2.5 * width + 1e-3);
      }
    }
  }
}

TEST(OffsetOutline, HasItsOuterLineBeforeWhatItEncloses) {
  // Beside an edge without an allowance, two others close in on a place.
  const PieceOutline star{"star",
                          {{{83.4118, 0.0},
                            {22.2927, 11.7001},
                            {44.5764, 64.58},
                            {11.926, 98.2198},
                            {-26.5745, 70.0712},
                            {-44.9987, 39.8654},
                            {-66.2525, 16.3298},
                            {-37.8096, -9.3192},
                            {-74.3227, -65.8442},
                            {-6.5498, -17.2703},
                            {2.4816, -20.4381},
                            {19.9157, -28.8528},
                            {8.8546, -4.6472}}}};
  const auto cut = offset_outline(
      star, {.mitre_limit = 4.8,
             .edge_widths = {{15.5, 9.5, 14.5, 11.5, 15.5, 12, 2, 12, 15.5, 5.5, 15, 15, 0}}});
  ASSERT_EQ(cut.size(), 2U);
  EXPECT_GT(signed_area(cut[0]), 0.0);
  EXPECT_LT(signed_area(cut[1]), 0.0);
}

TEST(OffsetOutline, KeepsItsWidthBesideAStretchWithoutWhereThereIsNoCorner) {
  for (const std::size_t points : {180U, 36U, 18U}) {  // the last turns by 20 degrees at each
    PieceOutline disc{"disc", {{}}};
    Allowance allowance{.width = 12.0, .edge_widths = {{}}};
    for (std::size_t i = 0; i < points; ++i) {
      const double angle =
          2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
      disc.loops[0].push_back({100.0 * std::cos(angle), 100.0 * std::sin(angle)});
      allowance.edge_widths[0].push_back(4 * i < points ? 0.0 : 12.0);
    }
    const Polygon& loop = disc.loops[0];
    const auto cut = offset_outline(disc, allowance);
    ASSERT_EQ(cut.size(), 1U);
    for (std::size_t i = 0; i < points; ++i) {
      if (!(allowance.edge_widths[0][i] > 0.0)) continue;
      const Vec2 middle = 0.5 * (loop[i] + loop[(i + 1) % points]);
      const Vec2 place = (1.0 + 12.0 / norm(middle)) * middle;
      EXPECT_LT(oracle::distance_to_outline(place, cut), 1e-3) << i << " of " << points;
    }
  }
}

TEST(OffsetOutline, RefusesFoldsThatAreNotOfItsEdges) {
  const PieceOutline plate{"plate", {{{0, 0}, {100, 0}, {100, 50}, {0, 50}}}};
  EXPECT_THROW(offset_outline(plate, {.folds = {{1, 0}}}), Error);
}

TEST(OffsetOutline, EndsAcrossTheSideWhereThatOnlyGoesOnWithout) {
  // A side of short edges in a zigzag, of which the allowance ends half way.
  PieceOutline outline{"side", {{{0, 0}}}};
  for (int i = 1; i < 20; ++i)
    outline.loops[0].push_back({10.0 * i, i % 2 == 1 ? 1.0 : 0.0});
  for (const Vec2 p : {Vec2{200, 0}, Vec2{200, 80}, Vec2{0, 80}})
    outline.loops[0].push_back(p);
  Allowance allowance{.width = 10.0};
  allowance.edge_widths = {std::vector<double>(outline.loops[0].size(), 0.0)};
  std::fill_n(allowance.edge_widths[0].begin(), 10, 10.0);
  const auto cut = offset_outline(outline, allowance);
  ASSERT_EQ(cut.size(), 1U);
  double lowest = 0.0;
  for (const Vec2 p : cut[0])
    lowest = p.x > 70.0 && p.x < 100.0 ? std::min(lowest, p.y) : lowest;
  EXPECT_LT(lowest, -8.9) << "as wide as asked up to its end";
}

}  // namespace
}  // namespace planish
