#include "sheet/stretch_directions.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

std::vector<Vec2> mapped(const TriMesh& mesh, double xx, double xy, double yx, double yy) {
  std::vector<Vec2> pattern;
  for (const Vec3 p : mesh.positions)
    pattern.push_back({xx * p.x + xy * p.y, yx * p.x + yy * p.y});
  return pattern;
}

TEST(StretchDirections, FindTheStretchThatWasMade) {
  const TriMesh mesh = meshes::flat_grid(30, 20);
  constexpr double angle = 0.4;
  const double c = std::cos(angle), s = std::sin(angle);
  // 3 % longer along the angle, 1 % shorter across.
  const auto pattern = mapped(mesh, 1.03 * c * c + 0.99 * s * s, 0.04 * c * s, 0.04 * c * s,
                              1.03 * s * s + 0.99 * c * c);
  const auto places = stretch_directions(mesh, pattern, 24);
  ASSERT_GE(places.size(), 12U);
  for (const StretchDirection& place : places) {
    EXPECT_NEAR(place.strain, 0.03, 1e-12);
    EXPECT_NEAR(std::abs(place.along.x * c + place.along.y * s), 1.0, 1e-12);
  }
}

TEST(StretchDirections, FindTheShorterWayWhereItIsTheWorse) {
  const TriMesh mesh = meshes::flat_grid(12, 12);
  for (const StretchDirection& place :
       stretch_directions(mesh, mapped(mesh, 1.01, 0.0, 0.0, 0.95), 9)) {
    EXPECT_NEAR(place.strain, -0.05, 1e-12);
    EXPECT_NEAR(std::abs(place.along.y), 1.0, 1e-12);
  }
}

TEST(StretchDirections, AreAsManyAsAskedForAboutAndInside) {
  const TriMesh mesh = meshes::flat_grid(60, 40);
  const auto places = stretch_directions(mesh, mapped(mesh, 1.0, 0.0, 0.0, 1.0), 150);
  EXPECT_GE(places.size(), 120U);
  EXPECT_LE(places.size(), 200U);
  for (const StretchDirection& place : places) {
    EXPECT_TRUE(place.at.x > 0.0 && place.at.x < 60.0 && place.at.y > 0.0 && place.at.y < 40.0);
    EXPECT_NEAR(place.strain, 0.0, 1e-12);
  }
}

TEST(DirectionLayer, DrawsWhatCanBeSeenAsLongAsItsShare) {
  const std::vector<StretchDirection> places = {{{0.0, 0.0}, {1.0, 0.0}, 0.01},
                                                {{5.0, 0.0}, {0.0, 1.0}, -0.02},
                                                {{9.0, 0.0}, {1.0, 0.0}, 1e-4}};
  const Layer layer = direction_layer(places, 0.02, 4.0);
  ASSERT_EQ(layer.shapes.size(), 1U);
  const auto& lines = std::get<Path>(layer.shapes.front()).lines;
  ASSERT_EQ(lines.size(), 6U) << "a line and two heads each, and none for what is hardly there";
  EXPECT_EQ(lines[0], (std::vector<Vec2>{{-1.0, 0.0}, {1.0, 0.0}}));
  EXPECT_EQ(lines[3], (std::vector<Vec2>{{5.0, -2.0}, {5.0, 2.0}}));
  EXPECT_EQ(lines[2][1].x, 1.0) << "the tip is outermost where it is longer";
  EXPECT_LT(lines[2][0].x, 1.0);
  EXPECT_LT(lines[5][1].y, lines[5][0].y) << "and inwards where it is shorter";
  EXPECT_TRUE(direction_layer({}, 0.02, 4.0).shapes.empty());
}

}  // namespace
}  // namespace planish
