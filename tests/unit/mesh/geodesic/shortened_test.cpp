#include <cmath>
#include <numbers>

#include <planish/mesh/geodesic.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/solids.h"

namespace planish {
namespace {

SurfacePoint vertex_place(const TriMesh& mesh, Index v) {
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] == v) return {{t[k], t[(k + 1) % 3], t[(k + 2) % 3]}, {1.0, 0.0, 0.0}};
    }
  }
  throw std::logic_error("no such vertex");
}

std::vector<SurfacePoint> along(const TriMesh& mesh, const std::vector<Index>& vertices) {
  std::vector<SurfacePoint> path;
  for (const Index v : vertices)
    path.push_back(vertex_place(mesh, v));
  return path;
}

double length_of_path(const TriMesh& mesh, const std::vector<SurfacePoint>& path) {
  double sum = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
    sum += norm(position_of(path[i], mesh.positions) - position_of(path[i - 1], mesh.positions));
  return sum;
}

/// Along random edges from vertex 0, never straight back.
std::vector<Index> wandering(const Patch& patch, std::size_t steps, std::uint64_t seed) {
  meshes::Random random(seed);
  std::vector<Index> path = {0};
  while (path.size() < steps) {
    const auto ring = patch.ring(path.back());
    const auto i =
        static_cast<std::size_t>(0.5 * (random.number() + 1.0) * static_cast<double>(ring.size()));
    path.push_back(ring[std::min(i, ring.size() - 1)]);
  }
  return path;
}

TEST(Shortened, IsAsShortAsTheGeodesicWhereThereIsOneWay) {
  const TriMesh mesh = meshes::flat_grid(8, 6);
  const auto path = along(mesh, {0, 1, 2, 12, 11, 20, 29, 39, 40, 41, 51, 61, 62});
  const GeodesicPath tight = shortened(Patch(mesh), path);
  EXPECT_NEAR(tight.length, std::hypot(8.0, 6.0), 1e-12);
  EXPECT_NEAR(length_of_path(mesh, tight.points), tight.length, 1e-12);
}

TEST(Shortened, NeverGetsLongerNorShorterThanTheGeodesic) {
  const std::vector<TriMesh> all = {meshes::rough_grid(12, 12, 1, 0.25, 1.2), meshes::torus(9, 14),
                                    solids::sphere(1.0, 8), solids::star_prism(),
                                    meshes::rough_grid(12, 12, 2)};
  for (const TriMesh& mesh : all) {
    const Patch patch(mesh);
    for (std::uint64_t seed = 1; seed < 20; ++seed) {
      const auto path = along(mesh, wandering(patch, 30, seed));
      const GeodesicPath tight = shortened(patch, path);
      EXPECT_LE(tight.length, length_of_path(mesh, path) * (1.0 + 1e-14));
      EXPECT_NEAR(length_of_path(mesh, tight.points), tight.length, 1e-12);
      EXPECT_GE(tight.length, geodesic(patch, path.front(), path.back()).length * (1 - 1e-12));
      // Nothing more to be had.
      EXPECT_NEAR(shortened(patch, tight.points).length, tight.length, 1e-13);
    }
  }
}

TEST(Shortened, StaysOnItsSideOfAHandle) {
  constexpr std::size_t around = 12;
  const TriMesh tube = meshes::tube(around, 4);
  const double side = 2.0 * std::sin(std::numbers::pi / around);
  // To the opposite side and two more, the long way; once around and more.
  std::vector<Index> path;
  for (Index i = 0; i <= around + 3; ++i) {
    path.push_back(i % around);
    if (i == 8) {
      path.push_back(static_cast<Index>(around + i % around));
      EXPECT_NEAR(shortened(Patch(tube), along(tube, path)).length, std::hypot(8 * side, 1.0),
                  1e-12);
      path.pop_back();
    }
  }
  path.push_back(around + 3);
  path.push_back(2 * around + 3);
  EXPECT_NEAR(shortened(Patch(tube), along(tube, path)).length, std::hypot(15 * side, 2.0), 1e-12);
}

TEST(ShortenedLoop, IsTheBeltOfATube) {
  constexpr Index around = 12;
  const TriMesh tube = meshes::tube(around, 4);
  std::vector<Index> loop;
  for (Index i = 0; i < around; ++i) {
    loop.push_back(around + i);
    loop.push_back(2 * around + (i + 1) % around);
  }
  loop.push_back(around);
  const GeodesicPath belt = shortened_loop(Patch(tube), along(tube, loop));
  EXPECT_NEAR(belt.length, 2.0 * around * std::sin(std::numbers::pi / around), 1e-12);
  EXPECT_NEAR(length_of_path(tube, belt.points), belt.length, 1e-12);
}

TEST(ShortenedLoop, FindsTheNeck) {
  constexpr Index around = 16, rows = 10;
  TriMesh mesh = meshes::tube(around, rows);
  for (Vec3& p : mesh.positions) {
    const double r = 1.0 + 0.05 * (p.z - 4.0) * (p.z - 4.0);  // narrowest in row 4
    p = {r * p.x, r * p.y, p.z};
  }
  std::vector<Index> loop;
  for (Index i = 0; i <= around; ++i)
    loop.push_back(9 * around + i % around);
  const GeodesicPath neck = shortened_loop(Patch(mesh), along(mesh, loop));
  EXPECT_NEAR(neck.length, 2.0 * around * std::sin(std::numbers::pi / around), 1e-12);
  for (const SurfacePoint& place : neck.points)
    EXPECT_NEAR(position_of(place, mesh.positions).z, 4.0, 1e-6);
}

TEST(ShortenedLoop, OfAHandleIsTheInnerRing) {
  constexpr Index around = 8, along_it = 24;
  const TriMesh torus = meshes::torus(around, along_it);
  std::vector<Index> loop;
  for (Index j = 0; j <= along_it; ++j)
    loop.push_back(j % along_it * around);  // the outer ring
  const GeodesicPath ring = shortened_loop(Patch(torus), along(torus, loop));
  EXPECT_NEAR(ring.length, 2.0 * along_it * 2.0 * std::sin(std::numbers::pi / along_it), 1e-9);
}

TEST(ShortenedLoop, ThatNothingHoldsVanishes) {
  const TriMesh sphere = solids::sphere(1.0, 8);
  std::vector<Index> loop;
  for (Index i = 0; i <= 16; ++i)
    loop.push_back(1 + 2 * 16 + i % 16);
  const GeodesicPath gone = shortened_loop(Patch(sphere), along(sphere, loop));
  EXPECT_EQ(gone.length, 0.0);
  EXPECT_EQ(gone.points.size(), 2U);
}

}  // namespace
}  // namespace planish
