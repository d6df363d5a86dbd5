#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <planish/core/error.h>
#include <planish/pattern/allowance.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish {
namespace {

using testing::HasSubstr;

/// A leg of 500 mm that tapers from 286 to 186 mm, its hem below; vertices 0 and 1 are its ends.
PieceOutline leg_with_hem() {
  return {"leg", {{{50, 0}, {236, 0}, {286, 500}, {0, 500}}}, {{0, 1, 2, 3}}};
}

std::vector<Polygon> cut_with_hem(const PieceOutline& outline, double side,
                                  std::vector<EdgeAllowance> edges) {
  return offset_outline(outline, with_edge_allowances({.width = side}, outline, edges));
}

/// How wide the first line is at a height.
double width_at(const Polygon& line, double y) {
  double low = 1e9, high = -1e9;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2 a = line[i], b = line[(i + 1) % line.size()];
    if ((a.y < y) == (b.y < y)) continue;
    const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
    low = std::min(low, x);
    high = std::max(high, x);
  }
  return high - low;
}

// The sides go out by 50 in 500 mm; beside the hem's line the leg with its allowances is
// 186 + 2 * 7 * sqrt(1 + 0.1^2) mm wide, and a height of 30 mm more or less changes that by 2 * 3.
TEST(Hems, AreTheMirrorImageOfWhatIsBehindThem) {
  const double at_line = 186.0 + 2.0 * 7.0 * std::sqrt(1.01);
  const auto plain = cut_with_hem(leg_with_hem(), 7.0, {{0, 1, 30.0}});
  const auto hem = cut_with_hem(leg_with_hem(), 7.0, {{0, 1, 30.0, false, true}});
  ASSERT_EQ(hem.size(), 1U);
  const double near_end = 29.99;
  EXPECT_NEAR(width_at(plain[0], -near_end), at_line - 0.2 * near_end, 1e-3);
  EXPECT_NEAR(width_at(hem[0], -near_end), at_line + 0.2 * near_end, 1e-3);
  for (const double height : {1.0, 10.0, 25.0})
    EXPECT_NEAR(width_at(hem[0], -height), width_at(hem[0], height), 2e-3) << height;
}

TEST(Hems, FollowSidesThatAreNotStraight) {
  const PieceOutline vase = {"vase",
                             {{{0, 0}, {100, 0}, {90, 10}, {105, 30}, {100, 200}, {0, 200}}},
                             {{0, 1, 2, 3, 4, 5}}};
  const auto cut = cut_with_hem(vase, 4.0, {{0, 1, 40.0, false, true}});
  for (const double height : {2.0, 8.0, 12.0, 20.0, 35.0})
    EXPECT_NEAR(width_at(cut[0], -height), width_at(cut[0], height), 2e-3) << height;
}

TEST(Hems, LieInAnyDirectionAndAreAsDeepAsAsked) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  PieceOutline outline = leg_with_hem();
  const double straight = signed_area(cut_with_hem(outline, 7.0, {{0, 1, 30.0, false, true}})[0]);
  for (Vec2& p : outline.loops[0])
    p = {c * p.x - s * p.y, s * p.x + c * p.y};
  const auto cut = cut_with_hem(outline, 7.0, {{0, 1, 30.0, false, true}});
  EXPECT_NEAR(signed_area(cut[0]), straight, 0.1);
  double deepest = 0.0;
  for (const Vec2 p : cut[0])
    deepest = std::min(deepest, c * p.y - s * p.x);
  EXPECT_NEAR(deepest, -30.0, 1e-3);
}

/// The ends of the x axis that a line covers at a height.
std::pair<double, double> span_at(const Polygon& line, double y) {
  double low = 1e9, high = -1e9;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vec2 a = line[i], b = line[(i + 1) % line.size()];
    if ((a.y < y) == (b.y < y)) continue;
    const double x = a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x);
    low = std::min(low, x);
    high = std::max(high, x);
  }
  return {low, high};
}

TEST(MirroredEnds, LieOnThePieceWhenTheSeamIsPressedOpen) {
  const PieceOutline outline = {
      "slanted", {{{0, 0}, {200, 0}, {230, 100}, {30, 100}}}, {{0, 1, 2, 3}}};
  const std::vector<PatternEdge> asked = {{.number = 1, .mirrors_ends = true}};
  const auto edges = allowances_of_edges(outline, asked, 12.0);
  const auto cut = offset_outline(outline, with_edge_allowances({.width = 12.0}, outline, edges));
  ASSERT_EQ(cut.size(), 1U);
  for (const double height : {0.5, 4.0, 11.0}) {
    const auto [low, high] = span_at(cut[0], height);
    const auto [low_below, high_below] = span_at(cut[0], -height);
    EXPECT_NEAR(low_below, low, 2e-3) << height;
    EXPECT_NEAR(high_below, high, 2e-3) << height;
  }
  const auto plain = offset_outline(outline, {.width = 12.0});
  EXPECT_NEAR(span_at(plain[0], -11.0).second, span_at(plain[0], 11.0).second - 6.6, 1e-3)
      << "without, the sides go on as they are";
}

TEST(MirroredEnds, ChangeNothingInTheMiddleOfACurvedSeam) {
  PieceOutline outline = {"curved", {{}}, {{}}};
  for (int k = 0; k <= 40; ++k)  // the lower side, as a bay 20 mm deep
    outline.loops[0].push_back({5.0 * k, 20.0 * std::sin(std::numbers::pi * k / 40.0)});
  outline.loops[0].push_back({230.0, 120.0});
  outline.loops[0].push_back({-30.0, 120.0});
  for (Index v = 0; v < outline.loops[0].size(); ++v)
    outline.vertices[0].push_back(v);
  const std::vector<PatternEdge> asked = {{.number = 1, .mirrors_ends = true}};
  const auto edges = allowances_of_edges(outline, asked, 8.0);
  ASSERT_EQ(edges.size(), 2U);
  EXPECT_EQ(edges[0].from, 0U);
  EXPECT_EQ(edges[1].to, 40U);
  const auto plain = offset_outline(outline, {.width = 8.0});
  const auto cut = offset_outline(outline, with_edge_allowances({.width = 8.0}, outline, edges));
  ASSERT_EQ(cut.size(), 1U);
  for (double x = 40.0; x <= 160.0; x += 7.0) {
    const auto lowest = [&](const Polygon& line) {
      double low = 1e9;
      for (std::size_t i = 0; i < line.size(); ++i) {
        const Vec2 a = line[i], b = line[(i + 1) % line.size()];
        if ((a.x < x) == (b.x < x)) continue;
        low = std::min(low, a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y));
      }
      return low;
    };
    EXPECT_NEAR(lowest(cut[0]), lowest(plain[0]), 0.02) << x;
  }
}

TEST(Hems, ThatCannotBeAreRefused) {
  const auto refusal = [](const PieceOutline& outline, double width) -> std::string {
    try {
      cut_with_hem(outline, 7.0, {{0, 1, width, false, true}});
    } catch (const Error& error) {
      return error.what();
    }
    return "none";
  };
  const PieceOutline flat = {"strip", {{{0, 0}, {300, 0}, {300, 20}, {0, 20}}}, {{0, 1, 2, 3}}};
  EXPECT_THAT(refusal(flat, 25.0), HasSubstr("a hem is 25 mm wide, and the piece behind it only"));
  const PieceOutline bent = {
      "bent", {{{0, 0}, {150, -5}, {300, 0}, {300, 90}, {0, 90}}}, {{0, 4, 1, 2, 3}}};
  EXPECT_THAT(refusal(bent, 10.0), HasSubstr("a hem is 5 mm off the line between its ends"));
}

TEST(EdgesByNumber, AreCountedFromTheLowestVertexAndBackwardsInAMirrorImage) {
  const PieceOutline leg = leg_with_hem();
  const auto of = [](const PieceOutline& outline, int number, bool clockwise) {
    const PatternEdge edge{.number = number, .allowance = 5.0, .clockwise = clockwise};
    const EdgeAllowance found = allowances_of_edges(outline, {&edge, 1}, 10.0).front();
    return std::pair(found.from, found.to);
  };
  EXPECT_EQ(of(leg, 1, false), std::pair(Index{0}, Index{1}));
  EXPECT_EQ(of(leg, 4, false), std::pair(Index{3}, Index{0}));
  PieceOutline later = leg;
  std::rotate(later.loops[0].begin(), later.loops[0].begin() + 2, later.loops[0].end());
  std::rotate(later.vertices[0].begin(), later.vertices[0].begin() + 2, later.vertices[0].end());
  EXPECT_EQ(of(later, 1, false), std::pair(Index{0}, Index{1})) << "whatever point comes first";
  PieceOutline image = leg;
  for (Vec2& p : image.loops[0])
    p.x = -p.x;
  std::reverse(image.loops[0].begin(), image.loops[0].end());
  std::reverse(image.vertices[0].begin(), image.vertices[0].end());
  EXPECT_EQ(of(image, 1, true), std::pair(Index{1}, Index{0})) << "the same edge";
  const PatternEdge none{.number = 5, .allowance = 5.0};
  EXPECT_THROW(allowances_of_edges(leg, {&none, 1}, 10.0), Error);
  const PatternEdge named{.number = 2, .name = "side"};
  EXPECT_THAT(words_of_edges(leg, {&named, 1}),
              testing::ElementsAre("edge 1", "side", "edge 3", "edge 4"));
}

}  // namespace
}  // namespace planish
