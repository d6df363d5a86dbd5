#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include <planish/pattern/curve.h>

#include <gtest/gtest.h>

#include "oracle/outline_distance.h"
#include "pattern/curves/corners.h"
#include "pattern/curves/piece_math.h"
#include "pattern/polygon/plane.h"

namespace planish {
namespace {

constexpr double k_pi = std::numbers::pi;

/// 400 x 200 mm whose upper side is a wave, with points about 4 mm apart.
Polygon panel(double noise = 0.0) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> off(-noise, noise);
  Polygon loop;
  const auto add = [&](double x, double y) { loop.push_back({x, y + off(random)}); };
  for (int k = 0; k < 100; ++k)
    add(4.0 * k, 0.0);
  for (int k = 0; k < 50; ++k)
    add(400.0, 4.0 * k);
  for (int k = 0; k < 100; ++k)
    add(400.0 - 4.0 * k, 200.0 + 30.0 * std::sin(k_pi * k / 50.0));
  for (int k = 0; k < 50; ++k)
    add(0.0, 200.0 - 4.0 * k);
  return loop;
}

Polygon circle(double radius, int count) {
  Polygon loop;
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * k_pi * k / count;
    loop.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return loop;
}

Polygon sampled(const Curve& curve, int places_a_piece = 200) {
  Polygon points;
  Vec2 from = curve.start;
  for (const CurvePiece& piece : curve.pieces) {
    for (int k = 0; k < places_a_piece; ++k)
      points.push_back(place_on(from, piece, static_cast<double>(k) / places_a_piece).at);
    from = end_of(piece);
  }
  return points;
}

double length_around(const Polygon& loop) {
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    length += norm(loop[(i + 1) % loop.size()] - loop[i]);
  return length;
}

/// The largest distance between two closed lines, in both directions.
double apart(const Polygon& a, const Polygon& b) {
  return std::max(oracle::distances({a}, {b}).most, oracle::distances({b}, {a}).most);
}

TEST(PieceMath, ArcsAreOnTheirCircle) {
  for (const double angle : {0.3, -1.0, 2.0, -3.0, 5.0}) {
    const auto at = [&](double share) {
      return Vec2{7.0 + 20.0 * std::cos(0.4 + share * angle), 20.0 * std::sin(0.4 + share * angle)};
    };
    const ArcTo arc = {at(0.5), at(1.0)};
    EXPECT_NEAR(circle_of(at(0.0), arc).angle, angle, 1e-12);
    EXPECT_NEAR(circle_of(at(0.0), arc).radius, 20.0, 1e-12);
    for (const double share : {0.0, 0.2, 0.5, 0.9, 1.0})
      EXPECT_NEAR(norm(place_on(at(0.0), arc, share).at - at(share)), 0.0, 1e-11);
    EXPECT_NEAR(length_of(at(0.0), arc), 20.0 * std::abs(angle), 1e-10);
    Vec2 from = at(0.0);
    for (const CubicTo& cubic : cubics_along(at(0.0), arc)) {
      for (double t = 0.0; t <= 1.0; t += 0.125)
        EXPECT_NEAR(norm(place_on(from, cubic, t).at - Vec2{7.0, 0.0}), 20.0, 0.0003 * 20.0);
      from = cubic.end;
    }
    EXPECT_EQ(from, at(1.0));
  }
}

TEST(PieceMath, DerivativesAreThoseOfDifferences) {
  const Vec2 start = {1, 2};
  const CurvePiece pieces[] = {CubicTo{{3, 9}, {8, -1}, {10, 4}}, ArcTo{{4, 5}, {8, 2}},
                               LineTo{{3, 3}}};
  for (const CurvePiece& piece : pieces) {
    for (const double t : {0.2, 0.7}) {
      const double h = 1e-4;
      const Vec2 before = place_on(start, piece, t - h).at,
                 after = place_on(start, piece, t + h).at;
      const PlaceOnPiece place = place_on(start, piece, t);
      EXPECT_NEAR(norm(0.5 / h * (after - before) - place.speed), 0.0, 1e-5);
      EXPECT_NEAR(norm(1.0 / (h * h) * (after - 2.0 * place.at + before) - place.bend), 0.0, 1e-4);
    }
  }
}

TEST(PieceMath, LengthIsThatOfManyChords) {
  const CubicTo cubic{{3, 90}, {80, -10}, {100, 40}};
  double length = 0.0;
  for (int k = 0; k < 100000; ++k)
    length += norm(place_on({}, cubic, (k + 1) / 1e5).at - place_on({}, cubic, k / 1e5).at);
  EXPECT_NEAR(length_of(Vec2{}, cubic), length, 1e-7);
}

TEST(PieceMath, ReversedCurvesGoThroughTheSamePlaces) {
  const Curve curve{{0, 0},
                    {LineTo{{10, 0}}, ArcTo{{14, 4}, {10, 8}}, CubicTo{{5, 9}, {2, 4}, {0, 0}}}};
  const Curve other = reversed(curve);
  EXPECT_NEAR(length_of(other), length_of(curve), 1e-12);
  EXPECT_NEAR(apart(sampled(curve), sampled(other)), 0.0, 1e-9);
  EXPECT_EQ(end_of(reversed(other).pieces[1]), end_of(curve.pieces[1]));
}

TEST(Corners, AreWhereALineTurnsAndNotWhereItIsJaggedOrRound) {
  EXPECT_EQ(corners_of(panel()), (std::vector<std::size_t>{0, 100, 150, 250}));
  EXPECT_TRUE(corners_of(circle(10.0, 40)).empty()) << "9 degrees a point";
  EXPECT_TRUE(corners_of(circle(30.0, 16)).empty()) << "22.5 degrees a point, but all around";
  Polygon jagged = panel();
  for (std::size_t k = 10; k < 90; k += 2)
    jagged[k].y += 2.0;  // 27 degrees and back
  EXPECT_EQ(corners_of(jagged).size(), 4U);
}

TEST(FitCurves, TakesLinesForStraightSidesAndFewCubicsForBends) {
  const Polygon loop = panel();
  const Curve curve = fit_curves({&loop, 1}).at(0);
  EXPECT_EQ(curve.start, loop[0]);
  EXPECT_LE(curve.pieces.size(), 12U);
  EXPECT_EQ(end_of(curve.pieces.back()), curve.start);
  EXPECT_TRUE(std::holds_alternative<LineTo>(curve.pieces[0]));
  EXPECT_EQ(end_of(curve.pieces[0]), loop[100]) << "from corner to corner";
  EXPECT_LE(apart(sampled(curve), loop), 0.1 + 1e-9);
  EXPECT_NEAR(length_of(curve), length_around(loop), 4 * 0.02);
}

TEST(FitCurves, TakesAnArcForAPartOfACircle) {
  Polygon loop = circle(80.0, 180);
  loop.resize(100);  // a little more than half
  const Curve curve = fit_curves({&loop, 1}).at(0);
  ASSERT_EQ(curve.pieces.size(), 2U);
  const auto arc = std::find_if(curve.pieces.begin(), curve.pieces.end(), [](const auto& piece) {
    return std::holds_alternative<ArcTo>(piece);
  });
  ASSERT_NE(arc, curve.pieces.end());
  EXPECT_LE(apart(sampled(curve), loop), 0.1);
}

TEST(FitCurves, FollowsALineWithoutCornersSmoothly) {
  const Polygon loop = circle(60.0, 150);
  const Curve curve = fit_curves({&loop, 1}).at(0);
  EXPECT_LE(curve.pieces.size(), 8U);
  EXPECT_LE(apart(sampled(curve), loop), 0.1);
  Vec2 from = curve.start;
  std::vector<Vec2> in, out;
  for (const CurvePiece& piece : curve.pieces) {
    out.push_back(direction_of(place_on(from, piece, 0.0).speed));
    in.push_back(direction_of(place_on(from, piece, 1.0).speed));
    from = end_of(piece);
  }
  for (std::size_t k = 0; k < in.size(); ++k)
    EXPECT_GT(dot(in[k], out[(k + 1) % out.size()]), 0.99999);
}

TEST(FitCurves, FitsADropWithOneCornerAlikeFromEveryFirstPoint) {
  // Two straight legs from a corner at the origin to an arc of radius 30 about (60, 0).
  Polygon drop;
  const double half = std::asin(0.5), leg = 60.0 * std::cos(half);
  for (int k = 0; k < 20; ++k)
    drop.push_back(leg * k / 20.0 * Vec2{std::cos(half), -std::sin(half)});
  for (int k = 0; k < 60; ++k) {
    const double angle = -0.5 * k_pi - half + (k_pi + 2.0 * half) * k / 60.0;
    drop.push_back({60.0 + 30.0 * std::cos(angle), 30.0 * std::sin(angle)});
  }
  for (int k = 0; k < 20; ++k)
    drop.push_back(leg * (20 - k) / 20.0 * Vec2{std::cos(half), std::sin(half)});
  const Curve curve = fit_curves({&drop, 1}).at(0);
  EXPECT_EQ(curve.start, (Vec2{0, 0}));
  EXPECT_LE(curve.pieces.size(), 8U);
  EXPECT_LE(apart(sampled(curve), drop), 0.1);
  std::rotate(drop.begin(), drop.begin() + 37, drop.end());
  const Curve turned = fit_curves({&drop, 1}).at(0);
  EXPECT_EQ(turned.start, (Vec2{0, 0}));
  EXPECT_EQ(turned.pieces.size(), curve.pieces.size());
}

TEST(FitCurves, KeepsToANoisyLineAndItsLength) {
  for (const double noise : {0.02, 0.05, 0.3}) {
    const Polygon loop = panel(noise);
    for (const double length_tolerance : {0.02, 0.003}) {
      const Curve curve =
          fit_curves({&loop, 1}, {.tolerance = 0.1, .length_tolerance = length_tolerance}).at(0);
      EXPECT_LE(apart(sampled(curve, 20), loop), 0.1 + 0.02) << noise;
      EXPECT_NEAR(length_of(curve), length_around(loop), 4.0 * length_tolerance) << noise;
    }
  }
}

TEST(FitCurves, FindsATighterFitWhereALargeToleranceMissesTheLength) {
  const Polygon loop = panel(0.02);
  for (const double tolerance : {0.1, 0.5, 5.0, 500.0}) {
    const Curve curve = fit_curves({&loop, 1}, {.tolerance = tolerance})[0];
    EXPECT_LT(curve.pieces.size(), loop.size() / 2) << tolerance;
    EXPECT_NEAR(length_of(curve), length_around(loop), 4 * 0.02) << tolerance;
  }
}

TEST(FitCurves, WithoutAToleranceIsTheLineItself) {
  const Polygon loop = panel();
  const Curve curve = fit_curves({&loop, 1}, {.tolerance = 0.0}).at(0);
  EXPECT_EQ(curve.pieces.size(), loop.size());
  EXPECT_EQ(end_of(curve.pieces[0]), loop[1]);
}

TEST(FewPoints, StayNearTheLineAndKeepItsLength) {
  for (const double noise : {0.0, 0.02, 0.05, 0.3}) {
    const Polygon loop = panel(noise);
    const Polygon few = simplify_polyline(loop);
    EXPECT_LE(apart(few, loop), 0.15 + 1e-9) << noise;
    EXPECT_NEAR(length_around(few), length_around(loop), 4 * 0.02) << noise;
    if (noise < 0.1) {
      EXPECT_LT(few.size(), 60U) << noise;
    }
  }
  const Polygon smooth = panel();
  EXPECT_NEAR(length_around(simplify_polyline(smooth)), length_around(smooth), 1e-6);
}

TEST(FewPoints, KeepCornersAndThePlacesThatAreAskedFor) {
  const Polygon loop = panel();
  const std::vector<Vec2> kept = {{121.3, 0.0}, loop[180], loop[180]};
  const Polygon few = simplify_polyline(loop, {.tolerance = 0.15}, kept);
  for (const Vec2 place : {loop[0], loop[100], loop[150], loop[250], kept[0], kept[1]})
    EXPECT_EQ(std::count(few.begin(), few.end(), place), 1) << place.x << " " << place.y;
}

TEST(FewPoints, HaveNoPointAtAPlaceThatIsNotOnTheLine) {
  const Polygon loop = panel();
  const std::vector<Vec2> kept = {{121.3, 5.0}, {500.0, 100.0}};
  EXPECT_EQ(simplify_polyline(loop, {.tolerance = 0.15}, kept), simplify_polyline(loop))
      << "of another loop";
}

TEST(FewPoints, LeaveSmallLoopsAlone) {
  const Polygon triangle = {{0, 0}, {10, 0}, {0, 10}};
  EXPECT_EQ(simplify_polyline(triangle), triangle);
  EXPECT_EQ(simplify_polyline({{0, 0}, {0, 0}, {10, 0}, {0, 10}, {0, 0}}), triangle) << "repeats";
  EXPECT_TRUE(simplify_polyline({}).empty());
  EXPECT_TRUE(fit_curves(std::vector<Polygon>{{}}).at(0).pieces.empty());
}

}  // namespace
}  // namespace planish
