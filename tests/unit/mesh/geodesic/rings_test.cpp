#include <cmath>
#include <numbers>

#include <planish/mesh/geodesic.h>

#include <gtest/gtest.h>

#include "mesh/geodesic/fronts.h"
#include "support/meshes.h"
#include "support/solids.h"

namespace planish {
namespace {

/// A closed vase along z with the radius r(z), z from 0 to the height.
template <class Radius>
TriMesh vase(std::size_t around, std::size_t along, double height, Radius radius) {
  TriMesh mesh = meshes::tube(around, along);
  for (Vec3& p : mesh.positions) {
    const double z = p.z * height / static_cast<double>(along);
    p = {radius(z) * p.x, radius(z) * p.y, z};
  }
  const auto low = static_cast<Index>(mesh.positions.size()), high = low + 1;
  mesh.positions.push_back({0.0, 0.0, -radius(0.0)});
  mesh.positions.push_back({0.0, 0.0, height + radius(height)});
  const auto last = static_cast<Index>(around * along);
  for (Index i = 0; i < around; ++i) {
    const auto next = static_cast<Index>((i + 1) % around);
    mesh.triangles.push_back({low, next, i});
    mesh.triangles.push_back({high, last + i, last + next});
  }
  return mesh;
}

/// Narrow at z = 3 and z = 8.
double two_necks(double z) {
  return 1.5 - std::exp(-(z - 3.0) * (z - 3.0)) * 0.9 - std::exp(-(z - 8.0) * (z - 8.0)) * 0.6;
}

double mean_height(const GeodesicPath& ring, const TriMesh& mesh) {
  double sum = 0.0;
  for (const SurfacePoint& point : ring.points)
    sum += position_of(point, mesh.positions).z;
  return sum / static_cast<double>(ring.points.size());
}

TEST(NarrowRings, AreTheNecksOfAVase) {
  const TriMesh mesh = vase(40, 60, 11.0, two_necks);
  const auto rings = narrow_rings(Patch(mesh));
  ASSERT_EQ(rings.size(), 2U);
  EXPECT_NEAR(mean_height(rings[0], mesh), 3.0, 0.2);
  EXPECT_NEAR(mean_height(rings[1], mesh), 8.0, 0.2);
  EXPECT_NEAR(rings[0].length, 2.0 * std::numbers::pi * two_necks(3.0), 0.03);
  EXPECT_NEAR(rings[1].length, 2.0 * std::numbers::pi * two_necks(8.0), 0.05);
}

TEST(NarrowRings, AreNoneWhereNothingIsNarrow) {
  EXPECT_TRUE(narrow_rings(Patch(solids::sphere(1.0, 14))).empty());
  EXPECT_TRUE(narrow_rings(Patch(meshes::flat_grid(10, 10))).empty());
  EXPECT_TRUE(narrow_rings(Patch(meshes::tube(20, 20))).empty());
}

TEST(NarrowRings, DoNotDependOnTheUnit) {
  TriMesh mesh = vase(24, 30, 11.0, two_necks);
  const auto rings = narrow_rings(Patch(mesh));
  for (Vec3& p : mesh.positions)
    p = 0x1p-40 * p;
  const auto small = narrow_rings(Patch(mesh));
  ASSERT_EQ(small.size(), rings.size());
  for (std::size_t k = 0; k < rings.size(); ++k)
    EXPECT_EQ(small[k].length, 0x1p-40 * rings[k].length);
}

TEST(RingAt, GoesToTheNeckThatIsNear) {
  const TriMesh mesh = vase(40, 60, 11.0, two_necks);
  const Patch patch(mesh);
  const auto ring = ring_at(patch, nearest_place(patch, {0.7, 0.0, 3.4}));
  ASSERT_TRUE(ring);
  EXPECT_NEAR(mean_height(*ring, mesh), 3.0, 0.2);
}

TEST(RingAt, StaysWhereNoNeckIsNear) {
  const TriMesh mesh = meshes::tube(24, 40);
  const Patch patch(mesh);
  const auto ring = ring_at(patch, nearest_place(patch, {1.0, 0.0, 17.0}));
  ASSERT_TRUE(ring);
  EXPECT_NEAR(mean_height(*ring, mesh), 17.0, 0.6);
  EXPECT_LE(ring->length, 2.0 * std::numbers::pi);
  EXPECT_GE(ring->length, 6.2);
}

TEST(RingAt, GoesAroundAHandle) {
  const Patch patch(meshes::torus(16, 30));
  const auto ring = ring_at(patch, nearest_place(patch, {4.0, 0.0, 0.0}));
  ASSERT_TRUE(ring);
  EXPECT_LE(ring->length, 2.0 * std::numbers::pi);
  EXPECT_GT(ring->length, 6.0);
}

TEST(RingAt, FindsNothingOnASheet) {
  const Patch patch(meshes::rough_grid(20, 20, 4, 0.2, 0.2));
  EXPECT_FALSE(ring_at(patch, nearest_place(patch, {10.0, 10.0, 0.0})));
}

TEST(Fronts, SpreadAtTheSameSpeedInAllDirections) {
  const TriMesh mesh = meshes::flat_grid(40, 40);
  const Patch patch(mesh);
  const Index middle = 41 * 20 + 20;
  const auto distances = distances_from(patch, std::vector{middle});
  for (std::size_t v = 0; v < distances.size(); ++v) {
    const double exact = norm(mesh.positions[v] - mesh.positions[middle]);
    EXPECT_NEAR(distances[v], exact, 0.3 * (1.0 + std::log(1.0 + exact)));
  }
  EXPECT_NEAR(front_length(mesh, distances, 12.0), 24.0 * std::numbers::pi,
              0.03 * 24.0 * std::numbers::pi);
}

TEST(Fronts, FromAStraightLineAreStraight) {
  const TriMesh mesh = meshes::flat_grid(8, 8);
  std::vector<Index> side;
  for (Index v = 0; v <= 8; ++v)
    side.push_back(v);
  const auto distances = distances_from(Patch(mesh), side);
  for (std::size_t v = 0; v < distances.size(); ++v)
    EXPECT_NEAR(distances[v], mesh.positions[v].y, 1e-12);
  EXPECT_NEAR(front_length(mesh, distances, 3.5), 8.0, 1e-12);
}

}  // namespace
}  // namespace planish
