#include "mesh/search/first_hit.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

/// The distance along the ray to the plane of a triangle, if the place there has no corner share
/// below 0.
std::optional<double> plain_distance(const BoxTree::Corners& c, Vec3 from, Vec3 direction) {
  const Vec3 normal = cross(c[1] - c[0], c[2] - c[0]);
  const double distance = dot(c[0] - from, normal) / dot(direction, normal);
  const Vec3 p = from + distance * direction;
  for (std::size_t k = 0; k < 3; ++k) {
    if (dot(cross(c[(k + 1) % 3] - c[k], p - c[k]), normal) < 0.0) return std::nullopt;
  }
  return distance;
}

TEST(FirstHit, IsThatOfAllTrianglesOneByOne) {
  TriMesh mesh = meshes::rough_grid(12, 9, 3, 0.3, 2.0);
  for (Vec3& p : mesh.positions)
    p = 0.05 * p;
  const BoxTree tree(mesh);
  meshes::Random random(5);
  std::size_t hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 from = Vec3{0.3, 0.2, 0.0} + meshes::random_point(random, 0.3);
    const Vec3 direction = meshes::random_point(random, 1.0);
    std::optional<Hit> wanted;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      BoxTree::Corners corners;
      for (std::size_t k = 0; k < 3; ++k)
        corners[k] = mesh.positions[mesh.triangles[t][k]];
      const auto distance = plain_distance(corners, from, direction);
      if (!distance || *distance <= 0.0 || (wanted && wanted->distance <= *distance)) continue;
      wanted = Hit{*distance, static_cast<Index>(t)};
    }
    const auto found = first_hit(tree, from, direction, 0.0);
    ASSERT_EQ(found.has_value(), wanted.has_value()) << i;
    if (!found) continue;
    ++hits;
    EXPECT_EQ(found->triangle, wanted->triangle) << i;
    EXPECT_NEAR(found->distance, wanted->distance, 1e-9 * (1.0 + wanted->distance)) << i;
  }
  EXPECT_GT(hits, 200U);
}

TEST(FirstHit, ThroughAVertexOrAnEdgeMeetsTheirTriangles) {
  TriMesh mesh = meshes::flat_grid(4, 4);
  const BoxTree tree(mesh);
  for (const Vec3 place : {Vec3{2, 2, 0}, Vec3{1.5, 1.5, 0}, Vec3{1, 2.5, 0}, Vec3{0, 0, 0}}) {
    const auto found = first_hit(tree, place + Vec3{0, 0, 3}, {0, 0, -1}, 1e-9);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->distance, 3.0);
  }
}

TEST(FirstHit, WhatIsNearerThanAskedForDoesNotCount) {
  const BoxTree tree(meshes::flat_grid(4, 4));
  EXPECT_FALSE(first_hit(tree, {1.2, 1.4, 0.0}, {0, 0, 1}, 1e-9));
  EXPECT_FALSE(first_hit(tree, {1.2, 1.4, 0.5}, {0, 0, 1}, 1e-9));
  EXPECT_TRUE(first_hit(tree, {1.2, 1.4, 0.5}, {0, 0, -1}, 1e-9));
  EXPECT_FALSE(first_hit(tree, {1.2, 1.4, 0.5}, {0, 0, -1}, 0.6));
}

}  // namespace
}  // namespace planish
