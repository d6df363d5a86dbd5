#include <cmath>
#include <limits>
#include <numbers>

#include <planish/mesh/geodesic.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/solids.h"

namespace planish {
namespace {

Vec3 end_of(const TriMesh& mesh, const GeodesicPath& path) {
  return position_of(path.points.back(), mesh.positions);
}

void expect_at(Vec3 p, Vec3 expected) {
  EXPECT_LT(norm(p - expected), 1e-12) << p.x << ' ' << p.y << ' ' << p.z;
}

TEST(Straightest, IsAStraightLineInThePlane) {
  const TriMesh mesh = meshes::flat_grid(8, 6);
  const Patch patch(mesh);
  // From a vertex, an edge and a triangle, in all directions, also along edges.
  const Triangle t = mesh.triangles[2 * (2 * 8 + 3)];
  for (const std::array<double, 3> shares :
       {std::array{1.0, 0.0, 0.0}, std::array{0.0, 0.0, 1.0}, std::array{0.3, 0.7, 0.0},
        std::array{0.5, 0.0, 0.5}, std::array{0.2, 0.3, 0.5}}) {
    const SurfacePoint from{t, shares};
    const Vec3 p = position_of(from, mesh.positions);
    for (int i = 0; i < 24; ++i) {
      const double angle = i * std::numbers::pi / 12;
      const Vec3 heading = {std::cos(angle), std::sin(angle), 0.0};
      const GeodesicPath path = straightest(patch, from, 3.0 * heading + Vec3{0, 0, 7}, 1.7);
      EXPECT_NEAR(path.length, 1.7, 1e-12);
      expect_at(end_of(mesh, path), p + 1.7 * heading);
    }
  }
}

TEST(Straightest, EndsAtTheBorder) {
  const TriMesh mesh = meshes::flat_grid(8, 6);
  const Patch patch(mesh);
  const SurfacePoint from{mesh.triangles[0], {0.2, 0.5, 0.3}};
  const Vec3 p = position_of(from, mesh.positions);
  const GeodesicPath path = straightest(patch, from, {1.0, 0.5, 0.0}, 100.0);
  expect_at(end_of(mesh, path), {8.0, p.y + 0.5 * (8.0 - p.x), 0.0});
  EXPECT_NEAR(path.length, std::hypot(1.0, 0.5) * (8.0 - p.x), 1e-12);
  // From the border outwards, and along it to its end.
  const SurfacePoint corner{mesh.triangles[0], {1.0, 0.0, 0.0}};
  EXPECT_EQ(straightest(patch, corner, {-1.0, 0.3, 0.0}, 1.0).length, 0.0);
  const SurfacePoint on_border{mesh.triangles[0], {0.5, 0.5, 0.0}};
  EXPECT_EQ(straightest(patch, on_border, {0.1, -1.0, 0.0}, 1.0).length, 0.0);
  EXPECT_NEAR(straightest(patch, on_border, {0.1, 1.0, 0.0}, 1.0).length, 1.0, 1e-12);
}

TEST(Straightest, GoesRoundACubeAndComesBack) {
  const TriMesh cube = solids::cube();
  const SurfacePoint from{cube.triangles[4], {0.2, 0.5, 0.3}};  // y is -1
  for (const Vec3 heading : {Vec3{1.0, 0.0, 0.0}, Vec3{0.0, 0.0, 1.0}}) {
    const GeodesicPath path = straightest(Patch(cube), from, heading, 8.0);
    EXPECT_NEAR(path.length, 8.0, 1e-12);
    expect_at(end_of(cube, path), position_of(from, cube.positions));
  }
}

TEST(Straightest, HasTheSameAngleOnBothSidesOfATip) {
  for (const TriMesh& fan : {meshes::fan(8, 0.8), meshes::ruffled_fan(8, 0.6)}) {
    const SurfacePoint from{fan.triangles[0], {0.5, 0.5, 0.0}};
    const Vec3 to_tip = fan.positions[0] - fan.positions[1];
    const GeodesicPath path = straightest(Patch(fan), from, to_tip, norm(to_tip));
    expect_at(end_of(fan, path), 0.5 * (fan.positions[0] + fan.positions[5]));
  }
}

TEST(Straightest, FollowsTheGeodesic) {
  const TriMesh sphere = solids::sphere(1.0, 12);
  const Patch patch(sphere);
  meshes::Random random(3);
  for (int i = 0; i < 20; ++i) {
    const auto triangle = [&] {
      return sphere.triangles[static_cast<std::size_t>(
          0.5 * (random.number() + 1.0) * static_cast<double>(sphere.triangles.size()))];
    };
    const SurfacePoint from{triangle(), {0.5, 0.3, 0.2}}, to{triangle(), {0.3, 0.3, 0.4}};
    const GeodesicPath path = geodesic(patch, from, to);
    const Vec3 heading = position_of(path.points[1], sphere.positions) -
                         position_of(path.points[0], sphere.positions);
    const GeodesicPath same = straightest(patch, from, heading, path.length);
    EXPECT_LT(norm(end_of(sphere, same) - position_of(to, sphere.positions)), 1e-10);
    EXPECT_EQ(same.points.size(), path.points.size());
  }
}

TEST(Straightest, RefusesWhatIsNoDirectionOrLength) {
  const TriMesh mesh = meshes::flat_grid(2, 2);
  const Patch patch(mesh);
  const SurfacePoint from{mesh.triangles[0]};
  for (const Vec3 bad :
       {Vec3{}, Vec3{0, 0, 1}, Vec3{std::numeric_limits<double>::quiet_NaN(), 0, 0}})
    EXPECT_THROW(straightest(patch, from, bad, 1.0), Error);
  for (const double bad :
       {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(straightest(patch, from, {1, 0, 0}, bad), Error);
  EXPECT_EQ(straightest(patch, from, {1, 0, 0}, 0.0).length, 0.0);
}

}  // namespace
}  // namespace planish
