#include <cmath>

#include <planish/measure/fairness.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "support/bent_sheets.h"
#include "support/meshes.h"
#include "support/solids.h"

namespace planish {
namespace {

/// Pairs that two triangles without a common vertex make, by trying all; long double throughout.
std::size_t plainly_counted(const TriMesh& mesh) {
  using Big = std::array<long double, 3>;
  const auto at = [&](Index v) {
    const Vec3 p = mesh.positions[v];
    return Big{static_cast<long double>(p.x), static_cast<long double>(p.y),
               static_cast<long double>(p.z)};
  };
  const auto volume = [](Big a, Big b, Big c, Big d) {
    for (int k = 0; k < 3; ++k)
      a[k] -= d[k], b[k] -= d[k], c[k] -= d[k];
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  const auto pierces = [&](Index p, Index q, const Triangle& t) {
    const Big a = at(t[0]), b = at(t[1]), c = at(t[2]), u = at(p), v = at(q);
    if (volume(a, b, c, u) * volume(a, b, c, v) >= 0.0L) return false;
    const long double x = volume(u, v, a, b), y = volume(u, v, b, c), z = volume(u, v, c, a);
    return (x > 0 && y > 0 && z > 0) || (x < 0 && y < 0 && z < 0);
  };
  const auto cross_at_all = [&](const Triangle& s, const Triangle& t) {
    for (int k = 0; k < 3; ++k) {
      if (pierces(s[k], s[(k + 1) % 3], t) || pierces(t[k], t[(k + 1) % 3], s)) return true;
    }
    return false;
  };
  std::size_t count = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (std::size_t j = i + 1; j < mesh.triangles.size(); ++j) {
      const Triangle &s = mesh.triangles[i], &t = mesh.triangles[j];
      bool apart = true;
      for (const Index v : s)
        apart = apart && v != t[0] && v != t[1] && v != t[2];
      if (apart && cross_at_all(s, t)) ++count;
    }
  }
  return count;
}

/// A strip that is wound up and pushed through itself.
TriMesh loop(std::size_t cells) {
  return meshes::bent_sheet(cells, [](double u, double v) {
    const double turn = 5.5 * u;
    return Vec3{std::sin(turn) + 0.4 * turn, v, std::cos(turn) + 0.05 * v};
  });
}

TEST(SelfIntersections, AreNoneOnSurfaces) {
  for (const Shape& shape : shapes())
    EXPECT_EQ(find_self_intersections(make_shape(shape.name, 3000)).pairs, 0U) << shape.name;
  for (const TriMesh& mesh : {meshes::torus(12, 9), solids::sphere(3.0, 20),
                              meshes::flat_grid(20, 20), meshes::crumpled_sheet(60), TriMesh{}}) {
    const SelfIntersections found = find_self_intersections(mesh);
    EXPECT_EQ(found.pairs, 0U);
    EXPECT_FALSE(found.first);
    EXPECT_TRUE(found.complete);
  }
}

TEST(SelfIntersections, AreThoseThatTryingAllPairsFinds) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const TriMesh mesh = meshes::rough_grid(12, 10, seed, 1.0, 0.8);
    const std::size_t expected = plainly_counted(mesh);
    EXPECT_GT(expected, 10U);
    EXPECT_EQ(find_self_intersections(mesh).pairs, expected) << seed;
  }
  const TriMesh mesh = loop(16);
  EXPECT_GT(plainly_counted(mesh), 20U);
  EXPECT_EQ(find_self_intersections(mesh).pairs, plainly_counted(mesh));
}

TEST(SelfIntersections, OfASurfaceThroughItselfAreAboutAsManyAsEdgesAlongTheCut) {
  const std::size_t coarse = find_self_intersections(loop(20)).pairs;
  const std::size_t fine = find_self_intersections(loop(80)).pairs;
  EXPECT_GT(coarse, 10U);
  EXPECT_NEAR(static_cast<double>(fine) / static_cast<double>(coarse), 4.0, 1.0);
}

TEST(SelfIntersections, HaveAPlace) {
  TriMesh mesh;
  mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 3}, {-5, 1, 3}};
  mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
  const SelfIntersections found = find_self_intersections(mesh);
  ASSERT_EQ(found.pairs, 1U);
  EXPECT_EQ(found.first->triangles, (std::array<Index, 2>{0, 1}));
  EXPECT_NEAR(norm(found.first->at - Vec3{0, 1, 0}), 0.0, 1e-15);
}

TEST(SelfIntersections, AreNotWhereItOnlyTouches) {
  TriMesh mesh = meshes::side_by_side(meshes::flat_grid(3, 3), meshes::flat_grid(3, 3));
  EXPECT_EQ(find_self_intersections(mesh).pairs, 0U);  // flat on itself
}

TEST(SelfIntersections, DoNotDependOnTheSizeOfTheModel) {
  const TriMesh mesh = meshes::rough_grid(10, 10, 2, 1.0, 0.8);
  const std::size_t pairs = find_self_intersections(mesh).pairs;
  for (const double size : {0x1p-400, 0x1p300}) {
    TriMesh other = mesh;
    for (Vec3& p : other.positions)
      p = size * p;
    EXPECT_EQ(find_self_intersections(other).pairs, pairs);
  }
}

TEST(SelfIntersections, AreGivenUpWhereThereIsNoSurface) {
  // Needles all through one place, each with vertices of its own.
  TriMesh mesh;
  for (Index i = 0; i < 4000; ++i) {
    const double turn = 0.001 * i;
    const Vec3 along{std::cos(turn), std::sin(turn), 0.3 * std::sin(7.0 * turn)};
    mesh.positions.insert(mesh.positions.end(),
                          {along, -along, Vec3{0.001, 0.0, 0.002 * std::cos(3.0 * turn)}});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  EXPECT_FALSE(find_self_intersections(mesh).complete);
}

}  // namespace
}  // namespace planish
