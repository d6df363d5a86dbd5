#include "mesh/search/nearest_vertex.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

/// By looking at every vertex.
Index plain_nearest(const TriMesh& mesh, Vec3 place) {
  Index best = mesh.triangles.front().front();
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    const Vec3 here = mesh.positions[v] - place, there = mesh.positions[best] - place;
    if (dot(here, here) < dot(there, there) || (dot(here, here) == dot(there, there) && v < best))
      best = v;
  }
  return best;
}

TEST(NearestVertex, IsWhatLookingAtEveryVertexFinds) {
  meshes::Random random(7);
  const TriMesh mesh = meshes::rough_grid(13, 9, 3);
  std::vector<Vec3> places;
  for (int i = 0; i < 500; ++i) {
    places.push_back({7.0 + 9.0 * random.number(), 5.0 + 7.0 * random.number(), random.number()});
  }
  const NearestVertex nearest(mesh, places);
  for (const Vec3 place : places)
    EXPECT_EQ(nearest.of(place), plain_nearest(mesh, place));
}

TEST(NearestVertex, IsTheSmallestNumberOfEquallyNearOnes) {
  const TriMesh mesh = meshes::flat_grid(8, 8);
  std::vector<Vec3> places;
  for (double x = 0.0; x <= 8.0; x += 0.5) {
    for (double y = 0.0; y <= 8.0; y += 0.5)
      places.push_back({x, y, 1.0});
  }
  const NearestVertex nearest(mesh, places);
  for (const Vec3 place : places)
    EXPECT_EQ(nearest.of(place), plain_nearest(mesh, place)) << place.x << " " << place.y;
}

TEST(NearestVertex, IsUsedByATriangle) {
  TriMesh mesh = meshes::flat_grid(2, 2);
  mesh.positions.push_back({10.0, 10.0, 0.0});
  EXPECT_EQ(NearestVertex(mesh, {{10.0, 10.0, 0.0}}).of({10.0, 10.0, 0.0}), 8U);
}

TEST(NearestVertex, IsFoundAtAnySize) {
  for (const double size : {1e-200, 1e200}) {
    TriMesh mesh = meshes::rough_grid(5, 5, 1);
    const Vec3 place = size * Vec3{3.1, 2.2, 0.0};
    const Index expected = plain_nearest(mesh, {3.1, 2.2, 0.0});
    for (Vec3& p : mesh.positions)
      p = size * p;
    EXPECT_EQ(NearestVertex(mesh, {place}).of(place), expected) << size;
  }
}

}  // namespace
}  // namespace planish
