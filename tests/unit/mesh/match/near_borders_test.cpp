#include <cmath>
#include <vector>

#include <planish/mesh/seams.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

/// A grid over [x0, x0 + 10] x [0, 20] on a cylinder along y, with so many rows.
TriMesh strip(double x0, int rows) {
  constexpr double radius = 30.0;
  TriMesh mesh = meshes::flat_grid(10, rows);
  for (Vec3& p : mesh.positions) {
    const double x = p.x + x0;
    p = {radius * std::sin(x / radius), p.y * 20.0 / rows, radius * std::cos(x / radius)};
  }
  return mesh;
}

/// A tolerance that only equal vertices keep.
constexpr double k_equal = 1e-12;

std::vector<NearBorders> near_borders(const std::vector<TriMesh>& patches, double tolerance = 0.0) {
  return find_near_borders(patches, find_seams(patches, tolerance));
}

TEST(NearBorders, AreFoundWhereTheToleranceIsTooSmall) {
  const auto near = near_borders({strip(0.0, 20), strip(10.02, 27)}, k_equal);
  ASSERT_EQ(near.size(), 1U);
  EXPECT_EQ(near[0].patches[0], 0U);
  EXPECT_EQ(near[0].patches[1], 1U);
  EXPECT_NEAR(near[0].length, 20.0, 1e-9);
}

TEST(NearBorders, AreNoneWhereThereIsASeamOrADistance) {
  EXPECT_TRUE(near_borders({strip(0.0, 20), strip(10.0, 20)}).empty()) << "a seam";
  EXPECT_TRUE(near_borders({strip(0.0, 20), strip(10.0, 27)}).empty()) << "a seam as curve";
  EXPECT_TRUE(near_borders({strip(0.0, 20), strip(10.3, 27)}).empty()) << "apart";
  EXPECT_TRUE(near_borders({strip(0.0, 20)}).empty());
  EXPECT_TRUE(near_borders({}).empty());
}

TEST(NearBorders, AreTwoSidesOfOnePatch) {
  // Once around, with other vertices on the last side.
  constexpr double turn = 6.28318530717958647692;
  TriMesh tube = meshes::flat_grid(40, 20);
  for (Vec3& p : tube.positions) {
    const double angle = turn * p.x / 40.0;
    const bool is_last = p.x == 40.0;
    const double shift = is_last && p.y > 0.0 && p.y < 20.0 ? 0.4 : 0.0;
    p = {(is_last ? 8.02 : 8.0) * std::sin(angle), p.y + shift,
         (is_last ? 8.02 : 8.0) * std::cos(angle)};
  }
  const auto near = near_borders({tube}, k_equal);
  ASSERT_EQ(near.size(), 1U);
  EXPECT_EQ(near[0].patches[0], near[0].patches[1]);
  EXPECT_NEAR(near[0].length, 20.0, 3.0) << "but for the ends, where edges are neighbours";
}

TEST(NearBorders, DoNotDependOnTheSizeOfTheModel) {
  std::vector<TriMesh> patches = {strip(0.0, 20), strip(10.02, 27)};
  for (TriMesh& patch : patches) {
    for (Vec3& p : patch.positions)
      p = 1e-9 * p;
  }
  const auto near = near_borders(patches, 1e-9 * k_equal);
  ASSERT_EQ(near.size(), 1U);
  EXPECT_NEAR(near[0].length, 20e-9, 1e-17);
}

}  // namespace
}  // namespace planish
