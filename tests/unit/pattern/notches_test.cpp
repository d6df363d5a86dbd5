#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include <planish/core/error.h>
#include <planish/pattern/allowance.h>
#include <planish/pattern/notches.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish {
namespace {

using testing::HasSubstr;

/// 100 x 50 mm; the border is 300 mm long and begins at vertex 3.
PieceOutline panel() {
  return {"panel", {{{0, 0}, {100, 0}, {100, 50}, {0, 50}}}, {{3, 7, 9, 20}}};
}

void expect_line(const Polygon& line, const Polygon& expected) {
  ASSERT_EQ(line.size(), expected.size());
  for (std::size_t i = 0; i < line.size(); ++i)
    EXPECT_NEAR(norm(line[i] - expected[i]), 0.0, 1e-4) << i;
}

/// The strokes of all notches.
std::vector<Polygon> notch_lines(const PieceOutline& outline, std::span<const Polygon> cut,
                                 std::span<const Notch> notches, const NotchSizes& sizes = {},
                                 const Allowance& allowance = {}) {
  std::vector<Polygon> lines;
  for (const PlacedNotch& notch : place_notches(outline, cut, notches, sizes, allowance))
    lines.insert(lines.end(), notch.strokes.begin(), notch.strokes.end());
  return lines;
}

Error error_of(const PieceOutline& outline, std::span<const Polygon> cut, const Notch& notch,
               const NotchSizes& sizes = {}, const Allowance& allowance = {}) {
  try {
    notch_lines(outline, cut, std::vector<Notch>{notch}, sizes, allowance);
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no error";
  return {ErrorCode::file_not_found, ""};
}

TEST(Notches, GoIntoThePieceWhereThereIsNoAllowance) {
  const PieceOutline outline = panel();
  const std::vector<Notch> notches{Notch::at_fraction(0.1, NotchKind::slit),
                                   Notch::at_fraction(0.4, NotchKind::v),
                                   Notch::at_fraction(0.1, NotchKind::t)};
  const auto lines = notch_lines(outline, outline.loops, notches);
  ASSERT_EQ(lines.size(), 4U);
  expect_line(lines[0], {{30, 0}, {30, 5}});
  expect_line(lines[1], {{100, 18}, {95, 20}, {100, 22}});
  expect_line(lines[2], {{30, 0}, {30, 5}});
  expect_line(lines[3], {{28, 5}, {32, 5}});
}

TEST(Notches, BeginAtTheCutLineAndPointAtTheSeam) {
  const PieceOutline outline = panel();
  const auto cut = offset_outline(outline, {.width = 10.0});
  const std::vector<Notch> notches{Notch::at_fraction(0.1, NotchKind::slit),
                                   Notch::at_fraction(0.4, NotchKind::v)};
  const auto lines = notch_lines(outline, cut, notches);
  ASSERT_EQ(lines.size(), 2U);
  expect_line(lines[0], {{30, -10}, {30, -5}});
  expect_line(lines[1], {{110, 18}, {105, 20}, {110, 22}});
}

TEST(Notches, AtVerticesStandAcrossTheCorner) {
  const PieceOutline outline = panel();
  const auto cut = offset_outline(outline, {.width = 10.0});
  const std::vector<Notch> notches{Notch::at_vertex(9, NotchKind::slit)};
  const auto lines = notch_lines(outline, cut, notches);
  const double deep = 5.0 / std::sqrt(2.0);
  expect_line(lines.at(0), {{110, 60}, {110 - deep, 60 - deep}});
}

TEST(Notches, ComeInPairsAlongTheSeam) {
  const PieceOutline outline = panel();
  const std::vector<Notch> notches{Notch::at_fraction(0.1, NotchKind::slit, true)};
  const auto lines = notch_lines(outline, outline.loops, notches, {.depth = 3.0, .spacing = 8.0});
  ASSERT_EQ(lines.size(), 2U);
  expect_line(lines[0], {{26, 0}, {26, 3}});
  expect_line(lines[1], {{34, 0}, {34, 3}});
}

TEST(Notches, SayWhereTheyBeginAndInWhichDirectionTheyRun) {
  const PieceOutline outline = panel();
  const auto cut = offset_outline(outline, {.width = 10.0});
  const std::vector<Notch> notches{Notch::at_fraction(0.1, NotchKind::slit),
                                   Notch::at_fraction(0.4, NotchKind::t, true)};
  const auto placed = place_notches(outline, cut, notches, {.depth = 4.0, .width = 3.0});
  ASSERT_EQ(placed.size(), 3U);
  expect_line({placed[0].at, placed[0].inward}, {{30, -10}, {0, 1}});
  EXPECT_EQ(placed[0].depth, 4.0);
  EXPECT_EQ(placed[0].width, 0.0) << "a slit has none";
  expect_line({placed[1].at, placed[1].inward}, {{110, 17}, {-1, 0}});
  expect_line({placed[2].at, placed[2].inward}, {{110, 23}, {-1, 0}});
  EXPECT_EQ(placed[1].width, 3.0);
}

TEST(Notches, AreNotTurnedByJags) {
  PieceOutline outline{"jags", {{}}};
  for (int k = 0; k <= 1000; ++k)
    outline.loops[0].push_back({0.1 * k, k % 2 == 0 ? 0.0 : 0.05});
  outline.loops[0].push_back({100, 50});
  outline.loops[0].push_back({0, 50});
  const std::vector<Notch> notches{Notch::at_fraction(0.1, NotchKind::slit)};
  const auto lines = notch_lines(outline, outline.loops, notches);
  const Vec2 along = lines.at(0)[1] - lines.at(0)[0];
  EXPECT_NEAR(along.x, 0.0, 0.15);
  EXPECT_NEAR(along.y, 5.0, 0.01);
}

TEST(Notches, RefuseToReachThroughTheSeamOrThePiece) {
  const PieceOutline outline = panel();
  const auto cut = offset_outline(outline, {.width = 4.0});
  const Error seam =
      error_of(outline, cut, Notch::at_fraction(0.1), {.depth = 4.5}, {.width = 4.0});
  EXPECT_EQ(seam.code(), ErrorCode::misplaced_notch);
  EXPECT_THAT(seam.message(), HasSubstr("piece \"panel\": the notch at 0.1 of the border"));
  EXPECT_THAT(seam.message(), HasSubstr("through the seam, which is 4 mm from the cut"));
  EXPECT_NO_THROW(
      notch_lines(outline, cut, std::vector<Notch>{Notch::at_fraction(0.1)}, {.depth = 4.0}));
  EXPECT_THAT(error_of(outline, outline.loops, Notch::at_fraction(0.1), {.depth = 51.0}).message(),
              HasSubstr("out of the piece"));
}

TEST(Notches, AreShorterBesideALesserAllowanceAndInThePieceBesideNone) {
  // Below 10 mm, on the right 3 mm, above none.
  const PieceOutline outline = panel();
  const Allowance allowance{.width = 10.0, .edge_widths = {{10.0, 3.0, 0.0, 10.0}}};
  const auto cut = offset_outline(outline, allowance);
  const std::vector<Notch> notches{Notch::at_fraction(0.1), Notch::at_fraction(125.0 / 300.0),
                                   Notch::at_fraction(200.0 / 300.0, NotchKind::v),
                                   Notch::at_fraction(100.0 / 300.0)};
  const auto lines = notch_lines(outline, cut, notches, {}, allowance);
  ASSERT_EQ(lines.size(), 4U);
  expect_line(lines[0], {{30, -10}, {30, -5}});
  expect_line(lines[1], {{103, 25}, {101.5, 25}});
  expect_line(lines[2], {{52, 50}, {50, 47.5}, {48, 50}});
  EXPECT_THAT(error_of(outline, cut, Notch::at_fraction(200.0 / 300.0), {.depth = 11.0}, allowance)
                  .message(),
              HasSubstr("through the seam, which is 0 mm from the cut"))
      << "deeper than any allowance";
}

TEST(Notches, OfADoubleOneAtTheEndOfAFoldAreBothBesideTheOtherEdge) {
  const PieceOutline outline = panel();
  for (const bool below : {true, false}) {
    // The fold is on the left, where the border ends.
    const Allowance allowance{.width = 10.0, .edge_widths = {{10.0, 10.0, 10.0, 0.0}}};
    const auto cut = offset_outline(outline, allowance);
    const Notch notch = Notch::at_vertex(below ? 3 : 20, NotchKind::slit, true);
    const auto placed = place_notches(outline, cut, std::vector<Notch>{notch}, {}, allowance);
    ASSERT_EQ(placed.size(), 2U);
    std::vector<double> xs = {placed[0].at.x, placed[1].at.x};
    std::sort(xs.begin(), xs.end());
    EXPECT_NEAR(xs[0], 0.0, 1e-4);
    EXPECT_NEAR(xs[1], 6.0, 1e-4);
    for (const PlacedNotch& some : placed)
      EXPECT_NEAR(some.at.y, below ? -10.0 : 60.0, 1e-4);
  }
}

TEST(Notches, RefusePlacesOffTheBorder) {
  const PieceOutline outline = panel();
  const Error vertex = error_of(outline, outline.loops, Notch::at_vertex(4));
  EXPECT_EQ(vertex.code(), ErrorCode::misplaced_notch);
  EXPECT_EQ(vertex.place().first, 4U);
  EXPECT_THAT(vertex.message(), HasSubstr("vertex 4 is off the border"));
  EXPECT_EQ(error_of(outline, outline.loops, Notch::at_fraction(1.01)).code(),
            ErrorCode::misplaced_notch);
  EXPECT_EQ(error_of(outline, outline.loops, Notch::at_fraction(-0.01)).code(),
            ErrorCode::misplaced_notch);
  EXPECT_EQ(error_of(outline, outline.loops, Notch::at_fraction(0.5), {.depth = 0.0}).code(),
            ErrorCode::option_out_of_range);
}

/// A panel 300 x 200 mm with a dart from the middle of its lower side, mouth and depth as told; the
/// points of the dart are vertices 1 (mouth), 2 (tip), 3 (mouth). Mirrored: the same in the line
/// x = 0.
PieceOutline panel_with_dart(double mouth, double depth, bool mirrored) {
  Polygon loop = {
      {0, 0},  {150 - 0.5 * mouth, 0}, {150, depth}, {150 + 0.5 * mouth, 0}, {300, 0}, {300, 200},
      {0, 200}};
  std::vector<Index> vertices = {0, 1, 2, 3, 4, 5, 6};
  if (mirrored) {
    for (Vec2& p : loop)
      p.x = -p.x;
    std::reverse(loop.begin(), loop.end());
    std::reverse(vertices.begin(), vertices.end());
  }
  return {"dart", {loop}, {vertices}};
}

struct DartCase {
  double mouth, depth, width;
  bool mirrored;
};

std::vector<DartCase> dart_cases() {
  std::vector<DartCase> cases;
  for (const bool mirrored : {false, true}) {
    for (const double mouth : {0.5, 8.0, 15.0, 40.0, 90.0}) {
      for (const double depth : {30.0, 83.0, 150.0}) {
        for (const double width : {6.0, 12.0, 25.0})
          cases.push_back({mouth, depth, width, mirrored});
      }
    }
  }
  return cases;
}

TEST(Notches, NeverLeaveTheirOwnEdgeBesideADart) {
  for (const DartCase& dart : dart_cases()) {
    const PieceOutline outline = panel_with_dart(dart.mouth, dart.depth, dart.mirrored);
    const Allowance allowance{.width = dart.width};
    const auto cut = offset_outline(outline, allowance);
    for (const double share : {0.02, 0.1, 0.5, 0.9, 0.98}) {
      for (const Notch& edge : {Notch::on_edge(1, 2, share), Notch::on_edge(3, 2, share)}) {
        const auto placed =
            place_notches(outline, cut, std::vector<Notch>{edge}, {.depth = 3.0}, allowance);
        ASSERT_EQ(placed.size(), 1U);
        const auto place_of = [&](Index v) {
          const auto& loop = outline.vertices[0];
          return outline.loops[0][std::find(loop.begin(), loop.end(), v) - loop.begin()];
        };
        const Vec2 seam =
            place_of(edge.edge->front()) + share * (place_of(2) - place_of(edge.edge->front()));
        EXPECT_LE(norm(placed[0].at - seam), 2.5 * dart.width + 1e-6)
            << dart.mouth << " " << dart.depth << " " << dart.width << " " << share;
        if (!placed[0].on_seam) continue;
        const Vec2 tip = placed[0].strokes[0].back();
        EXPECT_NEAR(norm(tip - seam), 0.0, 1e-6) << "ends on the seam line";
      }
    }
  }
}

TEST(Notches, AtTheMouthOfADartAreAsFarApartAsTheMouth) {
  for (const DartCase& dart : dart_cases()) {
    if (dart.mouth < 5.0) continue;
    const PieceOutline outline = panel_with_dart(dart.mouth, dart.depth, dart.mirrored);
    const Allowance allowance{.width = dart.width};
    const auto cut = offset_outline(outline, allowance);
    const std::vector<Notch> notches = {Notch::on_edge(1, 2, 0.0), Notch::on_edge(3, 2, 0.0)};
    const auto placed = place_notches(outline, cut, notches, {.depth = 3.0}, allowance);
    ASSERT_EQ(placed.size(), 2U);
    const double middle = dart.mirrored ? -150.0 : 150.0;
    EXPECT_NEAR(placed[0].at.x + placed[1].at.x, 2.0 * middle, 1e-3) << "mirror images";
    // Across the hem where the dart is filled, across its own legs where it is open.
    const double apart = norm(placed[0].at - placed[1].at);
    const bool across_hem = std::abs(placed[0].at.y + dart.width) < 0.02;
    if (across_hem) {
      EXPECT_NEAR(apart, dart.mouth, 0.05) << dart.depth << " " << dart.width;
    }
    const bool is_filled = dart.mouth < 1.9 * dart.width;
    EXPECT_TRUE(across_hem || !is_filled) << dart.mouth << " " << dart.depth << " " << dart.width;
  }
}

TEST(Notches, AtTheTipOfADartAreOne) {
  for (const DartCase& dart : dart_cases()) {
    const PieceOutline outline = panel_with_dart(dart.mouth, dart.depth, dart.mirrored);
    const Allowance allowance{.width = dart.width};
    const auto cut = offset_outline(outline, allowance);
    const std::vector<Notch> notches = {Notch::on_edge(1, 2, 1.0), Notch::on_edge(3, 2, 1.0)};
    const auto placed = place_notches(outline, cut, notches, {.depth = 3.0}, allowance);
    ASSERT_EQ(placed.size(), 1U) << dart.mouth << " " << dart.depth << " " << dart.width;
    const Vec2 tip = {dart.mirrored ? -150.0 : 150.0, dart.depth};
    EXPECT_LE(norm(placed[0].at - tip), 2.5 * dart.width + 1e-6);
    EXPECT_NEAR(placed[0].at.x, tip.x, 1e-6) << "in the middle of the dart";
  }
}

/// A shoulder: the upper side of a panel, whose corners have the angles told, from vertex 2 to 3.
PieceOutline panel_with_angles(double first, double second) {
  const double tan_first = std::tan(first * std::numbers::pi / 180.0);
  const double tan_second = std::tan(second * std::numbers::pi / 180.0);
  // The sides run down from (120, 0) and (0, 0), the shoulder lies along y = 0.
  return {"shoulder",
          {{{100.0 / tan_second, -100.0},
            {120.0 - 100.0 / tan_first, -100.0},
            {120.0, 0.0},
            {0.0, 0.0}}},
          {{0, 1, 2, 3}}};
}

TEST(Notches, AtTheEndsOfASeamStandAcrossIt) {
  for (const double first : {60.0, 75.0, 90.0, 110.0, 140.0}) {
    for (const double second : {65.0, 90.0, 120.0}) {
      for (const Corners corners : {Corners::mitre, Corners::square, Corners::round}) {
        for (const double width : {5.0, 10.0, 15.0}) {
          const PieceOutline outline = panel_with_angles(first, second);
          const Allowance allowance{.width = width, .corners = corners};
          const auto cut = offset_outline(outline, allowance);
          // The same edge named in both directions.
          const std::vector<Notch> notches = {Notch::on_edge(2, 3, 0.0), Notch::on_edge(2, 3, 1.0),
                                              Notch::on_edge(3, 2, 0.0), Notch::on_edge(3, 2, 1.0)};
          const auto placed = place_notches(outline, cut, notches, {.depth = 2.0}, allowance);
          ASSERT_EQ(placed.size(), 2U);
          expect_line({placed[0].at, placed[1].at}, {{120.0, width}, {0.0, width}});
          expect_line({placed[0].inward, placed[1].inward}, {{0, -1}, {0, -1}});
        }
      }
    }
  }
}

TEST(Notches, OfASideWithAnotherAllowanceReachItsCutLine) {
  const PieceOutline outline = panel();
  const Allowance allowance =
      with_edge_allowances({.width = 10.0}, outline, std::vector<EdgeAllowance>{{7, 9, 30.0}});
  const auto cut = offset_outline(outline, allowance);
  const auto placed =
      place_notches(outline, cut,
                    std::vector<Notch>{Notch::on_edge(7, 9, 0.0), Notch::on_edge(7, 9, 0.5),
                                       Notch::on_edge(3, 7, 1.0)},
                    {.depth = 2.0}, allowance);
  ASSERT_EQ(placed.size(), 3U);
  expect_line({placed[0].at, placed[1].at, placed[2].at}, {{130, 0}, {130, 25}, {100, -10}});
}

TEST(Notches, WhereAFoldMeetsAnEdgeAreInTheAllowanceOfThatAtTheFold) {
  for (const double lean : {-20.0, -5.0, 0.0, 5.0, 20.0}) {
    for (const double width : {6.0, 10.0, 20.0}) {
      // The fold runs down along x = 0 to the hem, which leaves it at 90 degrees less the lean.
      const double angle = lean * std::numbers::pi / 180.0;
      const Vec2 hem = {100.0 * std::cos(angle), 100.0 * std::sin(angle)};
      const PieceOutline outline{"half", {{{0, 0}, hem, {100, 150}, {0, 150}}}, {{3, 7, 9, 20}}};
      const Allowance allowance =
          with_edge_allowances({.width = width}, outline, std::vector<EdgeAllowance>{{20, 3, 0.0}});
      const auto cut = offset_outline(outline, allowance);
      const auto placed = place_notches(outline, cut, std::vector<Notch>{Notch::at_vertex(3)},
                                        {.depth = 3.0}, allowance);
      ASSERT_EQ(placed.size(), 1U);
      EXPECT_FALSE(placed[0].on_seam);
      expect_line({placed[0].at, placed[0].inward}, {{0.0, -width / std::cos(angle)}, {0, 1}});
      // Without an allowance too it is along the fold, at both ends, as it is on the whole piece.
      const auto bare = place_notches(
          outline, outline.loops,
          std::vector<Notch>{Notch::at_vertex(3), Notch::at_vertex(20), Notch::at_vertex(7)},
          {.depth = 3.0}, allowance);
      ASSERT_EQ(bare.size(), 3U);
      expect_line({bare[0].at, bare[0].inward}, {{0, 0}, {0, 1}});
      expect_line({bare[1].at, bare[1].inward}, {{0, 150}, {0, -1}});
      EXPECT_LT(bare[2].inward.x * bare[2].inward.y, 0.0) << "half way at another corner";
    }
  }
}

TEST(Notches, AtTheEndOfAFoldAreOnItsLineAlsoBesideACurvedEdge) {
  // A half with its fold along x = 0 and a hollow neckline of chords of 3 degrees.
  PieceOutline outline{"half", {{{0, 0}, {200, 0}, {200, 200}, {90, 200}}}, {{0, 1, 2, 3}}};
  for (int i = 1; i <= 30; ++i) {
    const double angle = 3.0 * i * std::numbers::pi / 180.0;
    outline.loops[0].push_back(
        {i < 30 ? 90.0 * std::cos(angle) : 0.0, 200.0 - 90.0 * std::sin(angle) - 0.2 * i});
    outline.vertices[0].push_back(static_cast<Index>(3 + i));
  }
  const Vec2 end = outline.loops[0].back();
  for (const double width : {12.0, 25.0}) {
    const Allowance allowance =
        with_edge_allowances({.width = width}, outline, std::vector<EdgeAllowance>{{33, 0, 0.0}});
    const auto cut = offset_outline(outline, allowance);
    const auto placed = place_notches(
        outline, cut, std::vector<Notch>{Notch::at_vertex(33, NotchKind::slit)}, {}, allowance);
    ASSERT_EQ(placed.size(), 1U);
    expect_line({placed[0].inward}, {{0, -1}});
    EXPECT_NEAR(placed[0].at.x, 0.0, 1e-4);
    EXPECT_GT(placed[0].at.y, end.y + width - 0.1);
    EXPECT_EQ(placed[0].depth, 5.0);
    double most = 0.0;
    for (const Vec2 p : cut[0])
      most = p.x < 1e-3 ? std::max(most, p.y) : most;
    EXPECT_NEAR(placed[0].at.y, most, 1e-4) << "where the cut line meets the fold";
  }
}

TEST(Notches, InASlitWithoutAGapAreHalfAMillimetreLong) {
  const PieceOutline outline{
      "slit", {{{0, 0}, {100, 0}, {100, 60}, {100, 0}, {200, 0}, {200, 100}, {0, 100}}}};
  const Allowance allowance{.width = 10.0};
  const auto cut = offset_outline(outline, allowance);
  const double border = 2.0 * (60.0 + 200.0 + 100.0);
  const auto lines = notch_lines(
      outline, cut,
      std::vector<Notch>{Notch::at_fraction(130.0 / border), Notch::at_fraction(190.0 / border)},
      {}, allowance);
  ASSERT_EQ(lines.size(), 2U);
  expect_line(lines[0], {{100.5, 30}, {100, 30}});
  expect_line(lines[1], {{99.5, 30}, {100, 30}});
}

TEST(Notches, OfADoubleOneStayOnTheirSeam) {
  const PieceOutline outline = panel();
  const Allowance allowance{.width = 10.0};
  const auto cut = offset_outline(outline, allowance);
  const auto placed = place_notches(
      outline, cut, std::vector<Notch>{Notch::on_edge(3, 7, 0.01, NotchKind::slit, true)}, {},
      allowance);
  ASSERT_EQ(placed.size(), 2U);
  expect_line({placed[0].at, placed[1].at}, {{0, -10}, {6, -10}});
}

}  // namespace
}  // namespace planish
