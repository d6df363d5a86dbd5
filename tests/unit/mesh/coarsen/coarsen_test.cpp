#include "mesh/coarsen/coarsen.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <planish/mesh/inspect.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "support/coarse_patches.h"
#include "support/meshes.h"

namespace planish {
namespace {

/// A grid without the cells of some rectangles.
TriMesh grid_with_holes(std::size_t size) {
  const TriMesh grid = meshes::height_field(size, size, [&](double x, double y) {
    return 0.1 * static_cast<double>(size) * std::sin(6.0 * x / static_cast<double>(size)) *
           std::cos(5.0 * y / static_cast<double>(size));
  });
  TriMesh mesh{grid.positions, {}};
  for (const Triangle& t : grid.triangles) {
    const Vec3 middle = grid.positions[t[0]] + grid.positions[t[1]] + grid.positions[t[2]];
    const double x = middle.x / (3.0 * static_cast<double>(size));
    const double y = middle.y / (3.0 * static_cast<double>(size));
    const bool left = x > 0.2 && x < 0.3 && y > 0.2 && y < 0.7;
    const bool right = x > 0.5 && x < 0.8 && y > 0.6 && y < 0.8;
    if (!left && !right) mesh.triangles.push_back(t);
  }
  return mesh;
}

TEST(Coarsen, KeepsTheTopologyOfEveryShape) {
  for (const Shape& shape : shapes()) {
    const TriMesh mesh = make_shape(shape.name, 3000);
    for (const std::size_t vertices : {0U, 10U, 100U, 1000U, 2900U}) {
      for (const CoarseBorder border : {CoarseBorder::thinned, CoarseBorder::kept}) {
        SCOPED_TRACE(std::string(shape.name) + " to " + std::to_string(vertices));
        const CoarsePatch patch = coarse(mesh, vertices, border);
        expect_sound(mesh, patch);
        EXPECT_GE(patch.source.size(), vertices);
      }
    }
  }
}

TEST(Coarsen, ComesDownToTheNumberAskedFor) {
  for (const Shape& shape : shapes()) {
    const TriMesh mesh = make_shape(shape.name, 3000);
    EXPECT_EQ(coarse(mesh, 300, CoarseBorder::thinned).source.size(), 300U) << shape.name;
  }
}

TEST(Coarsen, KeepsEveryLoop) {
  const TriMesh mesh = grid_with_holes(40);
  for (const std::size_t vertices : {0U, 50U, 400U}) {
    expect_sound(mesh, coarse(mesh, vertices, CoarseBorder::thinned));
    expect_sound(mesh, coarse(mesh, vertices, CoarseBorder::kept));
  }
  for (const auto& loop : loops_in_fine(coarse(mesh, 0, CoarseBorder::thinned)))
    EXPECT_GE(loop.size(), 4U);
}

TEST(Coarsen, CanKeepTheBorder) {
  const TriMesh mesh = grid_with_holes(40);
  const CoarsePatch patch = coarse(mesh, 700, CoarseBorder::kept);
  EXPECT_EQ(loops_in_fine(patch), Patch(mesh).border_loops());
}

TEST(Coarsen, GradesTheInsideOfAKeptBorder) {
  const TriMesh mesh = meshes::rough_grid(100, 100, 3, 0.2, 0.0);
  const CoarsePatch patch = coarse(mesh, 1200, CoarseBorder::kept);
  EXPECT_EQ(patch.source.size(), 1200U);
  EXPECT_GT(smallest_angles(patch.mesh).front(), 12.0);
  const Patch surface(patch.mesh);
  double outer = 0.0, inner = HUGE_VAL;  // extreme means of the edges around
  for (const Index v : surface.inner_vertices()) {
    const Vec3 p = patch.mesh.positions[v];
    const double depth = std::min({p.x, p.y, 100.0 - p.x, 100.0 - p.y});
    double mean = 0.0;
    for (const Index w : surface.ring(v))
      mean += norm(patch.mesh.positions[w] - p);
    mean /= static_cast<double>(surface.ring(v).size());
    if (depth < 1.5) outer = std::max(outer, mean);
    if (depth > 25.0) inner = std::min(inner, mean);
  }
  EXPECT_LT(outer, 3.0);
  EXPECT_GT(inner, 4.0);
}

TEST(Coarsen, StaysNearTheSurface) {
  for (const Shape& shape : shapes()) {
    const TriMesh mesh = make_shape(shape.name, 10'000);
    const CoarsePatch patch = coarse(mesh, 1000, CoarseBorder::thinned);
    EXPECT_LT(farthest(mesh, patch.mesh), 0.01) << shape.name;
    EXPECT_NEAR(meshes::area(patch.mesh) / meshes::area(mesh), 1.0, 0.02) << shape.name;
    EXPECT_GT(smallest_angles(patch.mesh).front(), 10.0) << shape.name;
  }
}

TEST(Coarsen, KeepsCorners) {
  const TriMesh mesh = meshes::flat_grid(60, 60);
  const CoarsePatch patch = coarse(mesh, 100, CoarseBorder::thinned);
  EXPECT_NEAR(meshes::area(patch.mesh), meshes::area(mesh), 1e-9);
}

TEST(Coarsen, KeepsWhatMustStay) {
  const TriMesh mesh = make_shape("dome", 2000);
  std::vector<unsigned char> keep(mesh.positions.size(), 0);
  for (std::size_t v = 0; v < keep.size(); v += 37)
    keep[v] = 1;
  for (const CoarseBorder border : {CoarseBorder::thinned, CoarseBorder::kept}) {
    const CoarsePatch patch = coarse(mesh, 10, border, keep);
    expect_sound(mesh, patch);
    for (Index v = 0; v < keep.size(); v += 37)
      EXPECT_TRUE(std::binary_search(patch.source.begin(), patch.source.end(), v)) << v;
  }
}

TEST(Coarsen, ReturnsASmallPatchAsItIs) {
  const TriMesh mesh = make_shape("saddle", 200);
  const CoarsePatch patch = coarse(mesh, mesh.positions.size(), CoarseBorder::thinned);
  EXPECT_EQ(patch.mesh.positions, mesh.positions);
  EXPECT_EQ(patch.mesh.triangles, mesh.triangles);
  for (Index v = 0; v < patch.source.size(); ++v)
    EXPECT_EQ(patch.source[v], v);
}

TEST(Coarsen, MakesTheSameTwice) {
  const TriMesh mesh = meshes::flat_grid(50, 50);  // full of ties
  const CoarsePatch once = coarse(mesh, 300, CoarseBorder::thinned);
  const CoarsePatch again = coarse(mesh, 300, CoarseBorder::thinned);
  EXPECT_EQ(once.source, again.source);
  EXPECT_EQ(once.mesh.triangles, again.mesh.triangles);
}

TEST(Coarsen, KnowsNoUnit) {
  const TriMesh mesh = make_shape("dome", 2000);
  const CoarsePatch patch = coarse(mesh, 300, CoarseBorder::thinned);
  for (const double scale : {0x1p-600, 0x1p600}) {
    TriMesh scaled = mesh;
    for (Vec3& p : scaled.positions)
      p = scale * p;
    EXPECT_EQ(coarse(scaled, 300, CoarseBorder::thinned).source, patch.source);
  }
}

TEST(Coarsen, GetsRidOfNeedles) {
  // Rows of the grid pressed together in pairs, a thousandth apart.
  TriMesh mesh = meshes::flat_grid(40, 40);
  for (Vec3& p : mesh.positions) {
    const auto row = static_cast<int>(p.y);
    if (row % 2 == 1 && row < 39) p.y = row - 0.999;
    p.z = 3.0 * std::sin(0.1 * p.x) * std::cos(0.1 * p.y);
  }
  ASSERT_LT(smallest_angles(mesh).front(), 0.1);
  const CoarsePatch patch = coarse(mesh, 400, CoarseBorder::thinned);
  expect_sound(mesh, patch);
  EXPECT_GT(smallest_angles(patch.mesh).front(), 10.0);
}

TEST(Coarsen, JoinsNoTwoVerticesAtOnePlace) {
  // Most places of a coarse lattice are taken by several vertices, which no edge may join.
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    meshes::Random random(seed);
    const auto step = [&] { return std::floor(1.5 + 1.5 * random.number()); };
    TriMesh mesh = meshes::flat_grid(6, 5);
    std::vector<unsigned char> keep;
    for (Vec3& p : mesh.positions) {
      p += {step(), step(), step()};
      keep.push_back(random.number() > 0.6 ? 1 : 0);
    }
    if (blocking_problem(inspect(mesh), Purpose::evolve)) continue;
    const CoarsePatch patch = coarsen(Patch(mesh), 15, CoarseBorder::kept, keep);
    EXPECT_FALSE(blocking_problem(inspect(patch.mesh), Purpose::measure)) << seed;
  }
}

TEST(Coarsen, SurvivesTrianglesWithoutArea) {
  TriMesh mesh = meshes::flat_grid(20, 20);
  for (std::size_t v = 100; v < 110; ++v)
    mesh.positions[v] = mesh.positions[100];
  const CoarsePatch patch = coarse(mesh, 100, CoarseBorder::thinned);
  expect_sound(mesh, patch);
  EXPECT_GT(smallest_angles(patch.mesh).front(), 5.0);
}

}  // namespace
}  // namespace planish
