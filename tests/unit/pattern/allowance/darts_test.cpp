#include "pattern/allowance/darts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oracle/outline_distance.h"
#include "pattern/polygon/polygon_rays.h"

namespace planish {
namespace {

/// A rectangle with a dart in its upper side, 60 mm deep and 20 mm wide, that the border comes to
/// from the right; edges 1 and 6 are the right and the left side.
PieceOutline dart_piece() {
  return {"front",
          {{{0, 0}, {200, 0}, {200, 100}, {110, 100}, {100, 40}, {90, 100}, {0, 100}}},
          {{0, 1, 2, 3, 4, 5, 6}}};
}

constexpr EdgeAllowance k_toward_right{1, 2, 0.0, false, false, true};
constexpr EdgeAllowance k_toward_left{6, 0, 0.0, false, false, true};

std::vector<Polygon> cut_with_dart(const PieceOutline& outline, const EdgeAllowance& toward,
                                   std::vector<EdgeAllowance> more = {}) {
  more.push_back(toward);
  return offset_outline(outline, with_edge_allowances({.width = 10.0}, outline, more));
}

Vec2 mirrored_in(Vec2 at, Vec2 along, Vec2 p) {
  const Vec2 foot = at + dot(p - at, along) / dot(along, along) * along;
  return foot + (foot - p);
}

TEST(Darts, AreFoundByTheirLegs) {
  const std::vector<FoldedDart> darts = darts_of(dart_piece());
  ASSERT_EQ(darts.size(), 1U);
  EXPECT_EQ(darts[0].from, 3U);
  EXPECT_EQ(darts[0].tip, 4U);
  EXPECT_EQ(darts[0].to, 5U);
  PieceOutline uneven = dart_piece();
  uneven.loops[0][3] = {110, 110};
  EXPECT_TRUE(darts_of(uneven).empty()) << "one leg is longer by 10 mm";
  PieceOutline wide = dart_piece();
  wide.loops[0][3] = {170, 100};
  wide.loops[0][5] = {30, 100};
  EXPECT_TRUE(darts_of(wide).empty()) << "a corner of more than 90 degrees";
  const PieceOutline square = {"square", {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}, {{0, 1, 2, 3}}};
  EXPECT_TRUE(darts_of(square).empty());
}

// When the dart is sewn, its cloth lies over the piece beside it: a point of it is in the cut piece
// exactly where the point that it comes to lie on is.
TEST(Darts, LieOnThePieceWhenTheyAreFolded) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> radius(0.0, 110.0), share(-1.0, 1.0);
  for (const bool to_right : {true, false}) {
    for (const double degrees : {0.0, 33.0, 181.0}) {
      PieceOutline outline = dart_piece();
      const double c = std::cos(degrees), s = std::sin(degrees);
      const auto turn = [&](Vec2 p) { return Vec2{c * p.x - s * p.y, s * p.x + c * p.y}; };
      for (Vec2& p : outline.loops[0])
        p = turn(p);
      const auto cut = cut_with_dart(outline, to_right ? k_toward_right : k_toward_left);
      ASSERT_EQ(cut.size(), 1U);
      const Vec2 tip = outline.loops[0][4], up = turn({0.0, 1.0});
      const Vec2 leg = outline.loops[0][to_right ? 3 : 5] - tip;
      const double half = std::atan2(10.0, 60.0), side = to_right ? 1.0 : -1.0;
      int inside = 0, outside = 0;
      for (int i = 0; i < 4000; ++i) {
        const double angle = half * share(random), r = radius(random);
        const Vec2 p = tip + r * (std::cos(angle) * up + std::sin(angle) * turn({1.0, 0.0}));
        const Vec2 near = side * angle > 0.0 ? p : mirrored_in(tip, up, p);
        const Vec2 on = mirrored_in(tip, leg, near);
        if (oracle::distance_to_outline(p, cut) < 0.01 ||
            oracle::distance_to_outline(on, cut) < 0.01)
          continue;
        EXPECT_EQ(is_within(cut, p), is_within(cut, on)) << p.x << " " << p.y;
        ++(is_within(cut, p) ? inside : outside);
      }
      EXPECT_GT(inside, 100);
      EXPECT_GT(outside, 100);
    }
  }
}

TEST(Darts, HaveACapAsHighAsWhatTheyLieOn) {
  const auto cut = cut_with_dart(dart_piece(), k_toward_left);
  double highest = 0.0;
  for (const Vec2 p : cut[0])
    highest = std::max(highest, p.y);
  // The middle of the dart comes to lie twice its half angle beside the middle line.
  EXPECT_NEAR(highest, 40.0 + 70.0 / std::cos(2.0 * std::atan2(10.0, 60.0)), 1e-3);
  EXPECT_TRUE(is_within(cut, {100.0, 41.0})) << "the cloth of the dart stays";
}

TEST(Darts, AreFoldedTowardTheNearerOfTwoEdges) {
  const PieceOutline outline = dart_piece();
  const auto is_toward_to = [&](const std::vector<LoopStretch>& stretches) {
    return darts_toward(outline, stretches).at(0).toward_to;
  };
  EXPECT_TRUE(is_toward_to({{0, 6, 0}}));
  EXPECT_FALSE(is_toward_to({{0, 1, 2}}));
  EXPECT_FALSE(is_toward_to({{0, 2, 3}, {0, 6, 0}})) << "the shoulder ends at the dart";
  EXPECT_TRUE(darts_toward(outline, {}).empty());
}

TEST(Darts, LeaveEdgesElsewhereAsTheyAre) {
  const PieceOutline outline = dart_piece();
  const auto open = offset_outline(outline, {.width = 10.0});
  const auto folded = cut_with_dart(outline, k_toward_left);
  for (const Vec2 p : folded[0]) {
    if (p.x > 60.0 && p.x < 140.0 && p.y > 20.0) continue;
    EXPECT_LT(oracle::distance_to_outline(p, open), 1e-4) << p.x << " " << p.y;
  }
}

}  // namespace
}  // namespace planish
