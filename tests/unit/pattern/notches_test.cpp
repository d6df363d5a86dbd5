#include <cmath>
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
                                 std::span<const Notch> notches, const NotchSizes& sizes = {}) {
  std::vector<Polygon> lines;
  for (const PlacedNotch& notch : place_notches(outline, cut, notches, sizes))
    lines.insert(lines.end(), notch.strokes.begin(), notch.strokes.end());
  return lines;
}

Error error_of(const PieceOutline& outline, std::span<const Polygon> cut, const Notch& notch,
               const NotchSizes& sizes = {}) {
  try {
    notch_lines(outline, cut, std::vector<Notch>{notch}, sizes);
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "no error";
  return {ErrorCode::file_not_found, ""};
}

TEST(Notches, GoIntoThePieceWhereThereIsNoAllowance) {
  const PieceOutline outline = panel();
  const std::vector<Notch> notches{
      {0.1, NotchKind::slit}, {0.4, NotchKind::v}, {0.1, NotchKind::t}};
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
  const std::vector<Notch> notches{{0.1, NotchKind::slit}, {0.4, NotchKind::v}};
  const auto lines = notch_lines(outline, cut, notches);
  ASSERT_EQ(lines.size(), 2U);
  expect_line(lines[0], {{30, -10}, {30, -5}});
  expect_line(lines[1], {{110, 18}, {105, 20}, {110, 22}});
}

TEST(Notches, AtVerticesStandAcrossTheCorner) {
  const PieceOutline outline = panel();
  const auto cut = offset_outline(outline, {.width = 10.0});
  const std::vector<Notch> notches{{Index{9}, NotchKind::slit}};
  const auto lines = notch_lines(outline, cut, notches);
  const double deep = 5.0 / std::sqrt(2.0);
  expect_line(lines.at(0), {{110, 60}, {110 - deep, 60 - deep}});
}

TEST(Notches, ComeInPairsAlongTheSeam) {
  const PieceOutline outline = panel();
  const std::vector<Notch> notches{{0.1, NotchKind::slit, true}};
  const auto lines = notch_lines(outline, outline.loops, notches, {.depth = 3.0, .spacing = 8.0});
  ASSERT_EQ(lines.size(), 2U);
  expect_line(lines[0], {{26, 0}, {26, 3}});
  expect_line(lines[1], {{34, 0}, {34, 3}});
}

TEST(Notches, SayWhereTheyBeginAndInWhichDirectionTheyRun) {
  const PieceOutline outline = panel();
  const auto cut = offset_outline(outline, {.width = 10.0});
  const std::vector<Notch> notches{{0.1, NotchKind::slit}, {0.4, NotchKind::t, true}};
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
  const std::vector<Notch> notches{{0.1, NotchKind::slit}};
  const auto lines = notch_lines(outline, outline.loops, notches);
  const Vec2 along = lines.at(0)[1] - lines.at(0)[0];
  EXPECT_NEAR(along.x, 0.0, 0.15);
  EXPECT_NEAR(along.y, 5.0, 0.01);
}

TEST(Notches, RefuseToReachThroughTheSeamOrThePiece) {
  const PieceOutline outline = panel();
  const auto cut = offset_outline(outline, {.width = 4.0});
  const Error seam = error_of(outline, cut, {0.1}, {.depth = 4.5});
  EXPECT_EQ(seam.code(), ErrorCode::misplaced_notch);
  EXPECT_THAT(seam.message(), HasSubstr("piece \"panel\": the notch at 0.1 of the border"));
  EXPECT_THAT(seam.message(), HasSubstr("through the seam, which is 4 mm from the cut"));
  EXPECT_NO_THROW(notch_lines(outline, cut, std::vector<Notch>{{0.1}}, {.depth = 4.0}));
  EXPECT_THAT(error_of(outline, outline.loops, {0.1}, {.depth = 51.0}).message(),
              HasSubstr("out of the piece"));
}

TEST(Notches, RefusePlacesOffTheBorder) {
  const PieceOutline outline = panel();
  const Error vertex = error_of(outline, outline.loops, {Index{4}});
  EXPECT_EQ(vertex.code(), ErrorCode::misplaced_notch);
  EXPECT_EQ(vertex.place().first, 4U);
  EXPECT_THAT(vertex.message(), HasSubstr("vertex 4 is off the border"));
  EXPECT_EQ(error_of(outline, outline.loops, {1.01}).code(), ErrorCode::misplaced_notch);
  EXPECT_EQ(error_of(outline, outline.loops, {-0.01}).code(), ErrorCode::misplaced_notch);
  EXPECT_EQ(error_of(outline, outline.loops, {0.5}, {.depth = 0.0}).code(),
            ErrorCode::option_out_of_range);
}

}  // namespace
}  // namespace planish
