#include <cmath>

#include <planish/core/error.h>
#include <planish/pattern/marks.h>

#include <gtest/gtest.h>

#include "oracle/outline_distance.h"
#include "support/meshes.h"

namespace planish {
namespace {

/// A quarter of a cylinder about the y axis, its pattern unrolled and turned by `angle`.
struct Rolled {
  TriMesh mesh;
  std::vector<Vec2> pattern;
};

Rolled quarter_cylinder(double angle) {
  Rolled rolled{meshes::flat_grid(12, 6), {}};
  for (Vec3& p : rolled.mesh.positions) {
    rolled.pattern.push_back({std::cos(angle) * p.x - std::sin(angle) * p.y,
                              std::sin(angle) * p.x + std::cos(angle) * p.y});
    const double turn = 1.57 * p.x / 12.0, radius = 12.0 / 1.57;
    p = {radius * std::sin(turn), p.y, radius * std::cos(turn)};
  }
  return rolled;
}

TEST(GrainDirection, IsCarriedOverWithThePattern) {
  for (const double angle : {0.0, 0.7, 3.0}) {
    const Rolled rolled = quarter_cylinder(angle);
    const Vec2 along = grain_direction(rolled.mesh, rolled.pattern, {0, 2, 0}, "");
    EXPECT_NEAR(along.x, -std::sin(angle), 1e-9);
    EXPECT_NEAR(along.y, std::cos(angle), 1e-9);
    const Vec2 around = grain_direction(rolled.mesh, rolled.pattern, {1, 0, -1}, "");
    EXPECT_NEAR(around.x, std::cos(angle), 1e-9);
    EXPECT_NEAR(around.y, std::sin(angle), 1e-9);
  }
}

TEST(GrainDirection, IsTheMeanByArea) {
  // Twice the triangles on one half change nothing.
  TriMesh mesh{{{0, 0, 0}, {2, 0, 0}, {2, 1, 1}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}};
  const std::vector<Vec2> pattern{{0, 0}, {2, 0}, {2.2, 1.4}, {0, 1}};
  const Vec2 coarse = grain_direction(mesh, pattern, {0.3, 1, 0.2}, "");
  mesh.positions.push_back({1, 0, 0});
  std::vector<Vec2> finer = pattern;
  finer.push_back({1, 0});
  mesh.triangles = {{0, 4, 2}, {4, 1, 2}, {0, 2, 3}};
  EXPECT_NEAR(norm(grain_direction(mesh, finer, {0.3, 1, 0.2}, "") - coarse), 0.0, 1e-12);
}

TEST(GrainDirection, IsRefusedWhereThereIsNone) {
  const TriMesh mesh = meshes::flat_grid(3, 3);
  std::vector<Vec2> pattern;
  for (const Vec3 p : mesh.positions)
    pattern.push_back({p.x, p.y});
  try {
    grain_direction(mesh, pattern, {0, 0, 1}, "sole");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::no_grain_direction);
    EXPECT_NE(error.message().find("piece \"sole\""), std::string::npos);
  }
}

/// A ring with a bay: much of what is in its box is outside of it.
PieceOutline horseshoe() {
  return {"horseshoe",
          {{{0, 0}, {120, 0}, {120, 160}, {80, 160}, {80, 40}, {40, 40}, {40, 160}, {0, 160}}}};
}

TEST(GrainLines, AreInsideThePieceInAnyDirection) {
  const PieceOutline outline = horseshoe();
  for (int k = 0; k < 36; ++k) {
    const double angle = 0.1745 * k;
    const auto lines = grain_lines(outline, {std::cos(angle), std::sin(angle)});
    ASSERT_EQ(lines.size(), 3U) << k;
    EXPECT_GT(norm(lines[0][1] - lines[0][0]), 25.0) << k;
    for (const Polygon& line : lines) {
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        for (int step = 0; step <= 50; ++step) {
          const Vec2 p = line[i] + step / 50.0 * (line[i + 1] - line[i]);
          EXPECT_TRUE(oracle::is_inside(p, outline.loops)) << k;
        }
      }
    }
  }
}

TEST(GrainLines, KeepClearOfABox) {
  const PieceOutline outline{"panel", {{{0, 0}, {100, 0}, {100, 60}, {0, 60}}}};
  const ClearBox box{{30, 20}, {70, 40}};
  const auto lines = grain_lines(outline, {1, 0}, box);
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_NEAR(norm(lines[0][1] - lines[0][0]), 80.0, 1e-9);
  EXPECT_TRUE(lines[0][0].y > 42.0 || lines[0][0].y < 18.0);
}

TEST(GrainLines, AreLeftOutOfWhatIsTooSmall) {
  const PieceOutline speck{"speck", {{{0, 0}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}}};
  EXPECT_TRUE(grain_lines(speck, {1, 0}).empty());
}

}  // namespace
}  // namespace planish
