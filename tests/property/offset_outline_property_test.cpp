#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <planish/pattern/allowance.h>

#include <gtest/gtest.h>

#include "oracle/outline_distance.h"
#include "property/property.h"

namespace planish {
namespace {

/// A star-shaped polygon: simple, and as ragged as the radii are.
PieceOutline random_outline() {
  const auto radii =
      *rc::gen::resize(100, rc::gen::container<std::vector<int>>(120, rc::gen::inRange(20, 100)));
  const auto count = static_cast<std::size_t>(*rc::gen::inRange(3, 120));
  PieceOutline outline{"random", {{}}};
  for (std::size_t k = 0; k < count; ++k) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(count);
    outline.loops[0].push_back({radii[k] * std::cos(angle), radii[k] * std::sin(angle)});
  }
  return outline;
}

void check(const PieceOutline& outline, const Allowance& allowance, double most) {
  const auto cut = offset_outline(outline, allowance);
  const auto range = oracle::distances(cut, outline.loops);
  RC_ASSERT(range.least > allowance.width - 0.0051);
  RC_ASSERT(range.most < most);
  RC_ASSERT(!oracle::any_cross(cut));
  RC_ASSERT(signed_area(cut.front()) > signed_area(outline.loops.front()));
}

PLANISH_PROPERTY(OffsetOutlineProperty, RoundIsAtItsDistanceEverywhere, 300) {
  const PieceOutline outline = random_outline();
  const double width = 0.5 * *rc::gen::inRange(1, 60);
  check(outline, {.width = width, .corners = Corners::round}, width + 1e-4);
}

PLANISH_PROPERTY(OffsetOutlineProperty, CornersReachNoFartherThanTheirLimit, 200) {
  const PieceOutline outline = random_outline();
  const double width = 0.5 * *rc::gen::inRange(1, 60);
  check(outline, {.width = width, .corners = Corners::mitre}, 2.5 * width + 1e-4);
  check(outline, {.width = width, .corners = Corners::square}, std::numbers::sqrt2 * width + 1e-4);
}

/// On an ellipse, at random places: a convex outline, whose corners may be cut off by short edges.
PieceOutline random_convex_outline() {
  const auto count = static_cast<std::size_t>(*rc::gen::resize(100, rc::gen::inRange(4, 16)));
  auto places =
      *rc::gen::resize(100, rc::gen::unique<std::vector<int>>(count, rc::gen::inRange(0, 3600)));
  std::sort(places.begin(), places.end());
  const double wide = *rc::gen::resize(100, rc::gen::inRange(50, 150));
  const double high = *rc::gen::resize(100, rc::gen::inRange(50, 150));
  PieceOutline outline{"random", {{}}};
  for (const int place : places) {
    const double angle = 2.0 * std::numbers::pi * place / 3600.0;
    outline.loops[0].push_back({wide * std::cos(angle), high * std::sin(angle)});
  }
  return outline;
}

/// How far a corner that turns inwards is at most from the line between its neighbours.
double deepest_notch(const Polygon& loop) {
  double deepest = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 before = loop[(i + loop.size() - 1) % loop.size()], at = loop[i];
    const Vec2 way = loop[(i + 1) % loop.size()] - before;
    if (norm(way) > 1e-3) deepest = std::max(deepest, cross(at - before, way) / -norm(way));
  }
  return deepest;
}

PLANISH_PROPERTY(OffsetOutlineProperty, MitresOfAConvexPieceLeaveNoNotch, 500) {
  const PieceOutline outline = random_convex_outline();
  RC_PRE(signed_area(outline.loops.front()) > 500.0);
  const double width = 0.5 * *rc::gen::resize(100, rc::gen::inRange(1, 60));
  const auto cut = offset_outline(outline, {.width = width});
  RC_ASSERT(cut.size() == 1U);
  RC_ASSERT(deepest_notch(cut.front()) < 0.005);
}

/// What is nearer than the width is inside, what is farther is outside: nothing is forgotten.
PLANISH_PROPERTY(OffsetOutlineProperty, RoundHoldsAllThatIsNearAndNothingElse, 100) {
  const PieceOutline outline = random_outline();
  const double width = 0.5 * *rc::gen::inRange(1, 60);
  const auto cut = offset_outline(outline, {.width = width, .corners = Corners::round});
  for (int k = 0; k < 200; ++k) {
    const Vec2 p{static_cast<double>(*rc::gen::inRange(-140, 140)) + 0.37,
                 static_cast<double>(*rc::gen::inRange(-140, 140)) + 0.41};
    const double distance =
        oracle::is_inside(p, outline.loops) ? 0.0 : oracle::distance_to_outline(p, outline.loops);
    if (std::abs(distance - width) < 0.006) continue;
    RC_ASSERT(oracle::is_inside(p, cut) == (distance < width));
  }
}

}  // namespace
}  // namespace planish
