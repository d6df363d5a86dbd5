#include <cmath>

#include <planish/unfold/strain.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

std::vector<Vec2> mapped(const TriMesh& mesh, double xx, double xy, double yx, double yy) {
  std::vector<Vec2> flat;
  for (const Vec3 p : mesh.positions)
    flat.push_back({xx * p.x + xy * p.y, yx * p.x + yy * p.y});
  return flat;
}

TEST(EdgeStrain, IsZeroForTheSameLengths) {
  const TriMesh mesh = meshes::flat_grid(4, 3);
  const EdgeStrain strain = edge_strain(mesh, Connectivity(mesh), mapped(mesh, 1, 0, 0, 1));
  EXPECT_EQ(strain.max, 0.0);
  EXPECT_EQ(strain.rms, 0.0);
}

TEST(EdgeStrain, CountsEveryEdgeOnce) {
  // 2 x 1 cells: 2 + 2 edges along x, 3 along y, 2 diagonals. Only x is stretched, by 10 %.
  const TriMesh mesh = meshes::flat_grid(2, 1);
  const EdgeStrain strain = edge_strain(mesh, Connectivity(mesh), mapped(mesh, 1.1, 0, 0, 1));
  const double diagonal = std::sqrt(2.21 / 2.0) - 1.0;
  EXPECT_NEAR(strain.max, 0.1, 1e-15);
  EXPECT_NEAR(strain.rms, std::sqrt((4 * 0.01 + 2 * diagonal * diagonal) / 9.0), 1e-15);
  EXPECT_NEAR(strain.p99, 0.1, 1e-15);
}

TEST(EdgeStrain, P99LeavesOutTheWorstHundredth) {
  TriMesh mesh = meshes::flat_grid(20, 20);
  const Connectivity connectivity(mesh);
  auto flat = mapped(mesh, 1, 0, 0, 1);
  flat[0] = {-0.5, 0.0};  // three of 1,240 edges
  const EdgeStrain strain = edge_strain(mesh, connectivity, flat);
  EXPECT_GT(strain.max, 0.2);
  EXPECT_EQ(strain.worst_edge[0], 0U) << "the vertex that was moved";
  EXPECT_EQ(strain.p99, 0.0);
}

TEST(PrincipalStretches, AreTheSingularValuesOfTheMap) {
  const TriMesh mesh = meshes::flat_grid(3, 3);
  for (const PrincipalStretch& s : principal_stretches(mesh, mapped(mesh, 0, -1.2, 0.9, 0))) {
    EXPECT_NEAR(s.max, 1.2, 1e-14);
    EXPECT_NEAR(s.min, 0.9, 1e-14);
  }
  for (const PrincipalStretch& s : principal_stretches(mesh, mapped(mesh, 1, 0, 0, -1))) {
    EXPECT_NEAR(s.min, -1.0, 1e-14) << "a mirrored triangle is flipped";
  }
}

TEST(PrincipalStretches, TakeATriangleWithoutAreaAsNotStretched) {
  const TriMesh mesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
  const auto stretch = principal_stretches(mesh, mapped(mesh, 1, 0, 0, 1));
  EXPECT_EQ(stretch[0].max, 1.0);
  EXPECT_EQ(stretch[0].min, 1.0);
}

TEST(SignedStrains, ShowTheLargerOfBothWithItsSign) {
  const std::vector<PrincipalStretch> stretches{{1.05, 0.99}, {1.01, 0.9}, {1.0, 1.0}};
  const auto strains = signed_strains(stretches);
  EXPECT_NEAR(strains[0], 0.05, 1e-15);
  EXPECT_NEAR(strains[1], -0.1, 1e-15);
  EXPECT_EQ(strains[2], 0.0);
}

}  // namespace
}  // namespace planish
