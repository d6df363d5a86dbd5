#include "mesh/search/closest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

/// Triangles anywhere, across each other; `flat` of them have no area.
TriMesh random_soup(std::size_t count, meshes::Random& random, bool flat = false) {
  TriMesh mesh;
  for (Index t = 0; t < count; ++t) {
    const Vec3 middle = meshes::random_point(random, 1.0);
    for (int k = 0; k < 3; ++k)
      mesh.positions.push_back(middle + meshes::random_point(random, 0.2));
    if (flat && t % 2 == 0) {
      const Vec3 a = mesh.positions[3 * t], b = mesh.positions[3 * t + 1];
      mesh.positions[3 * t + 2] = a + (t % 3 == 0 ? 0.0 : 0.3) * (b - a);
    }
    if (flat && t % 10 == 0) mesh.positions[3 * t + 1] = mesh.positions[3 * t];
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return mesh;
}

/// By looking at one triangle after another.
ClosestPoint one_by_one(const TriMesh& mesh, Vec3 p) {
  ClosestPoint best;
  best.squared_distance = std::numeric_limits<double>::infinity();
  for (Index t = 0; t < mesh.triangles.size(); ++t) {
    ClosestPoint found = ClosestPointTree({mesh.positions, {mesh.triangles[t]}}).query(p);
    found.triangle = t;
    if (found.squared_distance < best.squared_distance) best = found;
  }
  return best;
}

/// The squared distance to a triangle by minimising over its barycentric coordinates: along the
/// second, then along the first, both convex.
double searched_squared_distance(Vec3 a, Vec3 b, Vec3 c, Vec3 p) {
  const auto least = [](const auto& f) {
    double low = 0.0, high = 1.0;
    for (int step = 0; step < 90; ++step) {
      const double s = low + (high - low) / 3.0, t = high - (high - low) / 3.0;
      (f(s) < f(t) ? high : low) = f(s) < f(t) ? t : s;
    }
    return std::min({f(low), f(0.0), f(1.0)});
  };
  return least([&](double s) {
    const Vec3 at = a + s * (b - a), to = a + s * (c - a);
    return least([&](double t) {
      const Vec3 d = at + t * (to - at) - p;
      return dot(d, d);
    });
  });
}

void expect_consistent(const TriMesh& mesh, const ClosestPoint& found, Vec3 p) {
  Vec3 mean;
  double sum = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_GE(found.barycentric[k], 0.0);
    sum += found.barycentric[k];
    mean += found.barycentric[k] * mesh.positions[mesh.triangles[found.triangle][k]];
  }
  EXPECT_NEAR(sum, 1.0, 1e-15);
  EXPECT_LT(norm(mean - found.point), 1e-14);
  EXPECT_EQ(found.squared_distance, dot(found.point - p, found.point - p));
}

void expect_equal(const ClosestPoint& a, const ClosestPoint& b) {
  EXPECT_EQ(a.triangle, b.triangle);
  EXPECT_EQ(a.point, b.point);
  EXPECT_EQ(a.squared_distance, b.squared_distance);
  EXPECT_EQ(a.barycentric, b.barycentric);
}

TEST(ClosestPointTree, FindsTheNearestPointOfATriangle) {
  meshes::Random random(1);
  for (int round = 0; round < 60; ++round) {
    const TriMesh mesh = random_soup(1, random);
    const Vec3 p = meshes::random_point(random, 1.5);
    const ClosestPoint found = ClosestPointTree(mesh).query(p);
    const double least =
        searched_squared_distance(mesh.positions[0], mesh.positions[1], mesh.positions[2], p);
    EXPECT_NEAR(found.squared_distance, least, 1e-12);
    expect_consistent(mesh, found, p);
  }
}

TEST(ClosestPointTree, FindsTheNearestPointOfNeedlesAndOfTrianglesWithoutArea) {
  meshes::Random random(2);
  for (const double height : {0.0, 1e-17, 1e-12, 1e-8, 1e-5}) {
    for (const double x : {-0.5, 0.0, 0.3, 1.0, 1.5}) {
      const TriMesh mesh{{{0, 0, 0}, {1, 0, 0}, {x, height, 0}}, {{0, 1, 2}}};
      const ClosestPointTree tree(mesh);
      for (int round = 0; round < 20; ++round) {
        const Vec3 p = meshes::random_point(random, 2.0);
        const ClosestPoint found = tree.query(p);
        // A segment, but for its height.
        const double to = std::clamp(p.x, std::min(0.0, x), std::max(1.0, x));
        const double distance = norm(p - Vec3{to, 0.0, 0.0});
        EXPECT_NEAR(std::sqrt(found.squared_distance), distance, height + 1e-15);
        expect_consistent(mesh, found, p);
      }
    }
  }
  const TriMesh point{{{1, 2, 3}}, {{0, 0, 0}}};
  EXPECT_EQ(ClosestPointTree(point).query({1, 2, 5}).squared_distance, 4.0);
}

TEST(ClosestPointTree, FindsWhatLookingAtAllTrianglesFindsToTheLastBit) {
  meshes::Random random(3);
  for (const std::size_t count : {1U, 4U, 5U, 9U, 100U, 700U}) {
    for (const bool flat : {false, true}) {
      const TriMesh mesh = random_soup(count, random, flat);
      const ClosestPointTree tree(mesh);
      for (int round = 0; round < 20; ++round) {
        const Vec3 p = meshes::random_point(random, round % 2 == 0 ? 1.0 : 20.0);
        expect_equal(tree.query(p), one_by_one(mesh, p));
      }
    }
  }
}

TEST(ClosestPointTree, TakesTheSmallestNumberOfEquallyNearTriangles) {
  // Everything several times, and queries on edges, at vertices and above them.
  TriMesh mesh = meshes::flat_grid(6, 6);
  const auto once = mesh.triangles;
  mesh.triangles.insert(mesh.triangles.end(), once.begin(), once.end());
  std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  const ClosestPointTree tree(mesh);
  for (const double z : {0.0, 0.5}) {
    for (double x = -1.0; x <= 7.0; x += 0.5) {
      for (double y = -1.0; y <= 7.0; y += 0.5)
        expect_equal(tree.query({x, y, z}), one_by_one(mesh, {x, y, z}));
    }
  }
}

TEST(ClosestPointTree, TellsCornersAndSidesByZeros) {
  const TriMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  const ClosestPointTree tree(mesh);
  using Shares = std::array<double, 3>;
  EXPECT_EQ(tree.query({-1, -2, 3}).barycentric, (Shares{1, 0, 0}));
  EXPECT_EQ(tree.query({3, -1, 1}).barycentric, (Shares{0, 1, 0}));
  EXPECT_EQ(tree.query({0.25, -1, 1}).barycentric, (Shares{0.75, 0.25, 0}));
  EXPECT_EQ(tree.query({2, 2, 0}).barycentric, (Shares{0, 0.5, 0.5}));
  EXPECT_EQ(tree.query({-5, 0.25, 0}).barycentric, (Shares{0.75, 0, 0.25}));
  EXPECT_EQ(tree.query({0.25, 0.25, 9}).barycentric, (Shares{0.5, 0.25, 0.25}));
}

TEST(ClosestPointTree, FindsVerticesOfARealPatchAtThemselves) {
  const TriMesh mesh = make_shape("panel", 3000);
  const ClosestPointTree tree(mesh);
  for (Index v = 0; v < mesh.positions.size(); v += 7) {
    const ClosestPoint found = tree.query(mesh.positions[v]);
    EXPECT_EQ(found.squared_distance, 0.0);
    EXPECT_EQ(found.point, mesh.positions[v]);
  }
}

}  // namespace
}  // namespace planish
