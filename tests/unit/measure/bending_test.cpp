#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <planish/measure/fairness.h>

#include <gtest/gtest.h>

#include "support/bent_sheets.h"
#include "support/meshes.h"
#include "support/solids.h"

namespace planish {
namespace {

using std::numbers::pi;

Bending bending_of(const TriMesh& mesh) {
  return measure_bending(Patch(mesh));
}

/// Two triangles over the edge from (0, 0, 0) to (2, 0, 0), the right one raised by an angle.
TriMesh hinge(double angle) {
  TriMesh mesh;
  mesh.positions = {{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -std::cos(angle), std::sin(angle)}};
  mesh.triangles = {{0, 1, 2}, {1, 0, 3}};
  return mesh;
}

TEST(Bends, HaveTheSignOfValleyAndRidge) {
  for (const double angle : {-3.0, -1.0, -1e-9, 0.0, 1e-9, 0.5, 2.0, 3.1}) {
    const TriMesh mesh = hinge(angle);
    const std::vector<Hinge> hinges = hinges_of(Patch(mesh));
    ASSERT_EQ(hinges.size(), 1U);
    const Bend bend = bend_of(hinges.front(), mesh.positions);
    EXPECT_NEAR(bend.angle, angle, 1e-15 + 1e-15 * std::abs(angle));
    EXPECT_DOUBLE_EQ(bend.length, 2.0);
    EXPECT_NEAR(bend.area, 2.0 / 3.0, 1e-15);
    // 3 t^2 l^2 / (A1 + A2)
    EXPECT_NEAR(bend.bending(), 6.0 * angle * angle, 1e-13);
    EXPECT_NEAR(bending_of(mesh).bending, 6.0 * angle * angle, 1e-13);
    EXPECT_NEAR(bending_of(mesh).mean_curvature, std::abs(angle) / std::sqrt(2.0), 1e-14);
  }
}

TEST(Bends, AreOfEachInnerEdgeOnce) {
  for (const TriMesh& mesh :
       {meshes::rough_grid(7, 5, 1), meshes::tube(7, 4), meshes::torus(9, 8), meshes::fan(5)}) {
    const Patch patch(mesh);
    std::size_t border = 0;
    for (const auto& loop : patch.border_loops())
      border += loop.size();
    const std::vector<Hinge> hinges = hinges_of(patch);
    EXPECT_EQ(2 * hinges.size(), 3 * mesh.triangles.size() - border);
    for (const Hinge& hinge : hinges) {
      const auto has = [&](Index a, Index b, Index c) {
        return std::any_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
          return t == Triangle{a, b, c} || t == Triangle{b, c, a} || t == Triangle{c, a, b};
        });
      };
      EXPECT_LT(hinge.from, hinge.to);
      EXPECT_TRUE(has(hinge.from, hinge.to, hinge.left));
      EXPECT_TRUE(has(hinge.to, hinge.from, hinge.right));
    }
  }
}

TEST(Bending, OfAPlaneIsNothing) {
  EXPECT_EQ(bending_of(meshes::flat_grid(8, 6)).bending, 0.0);
  // Tilted, its positions are rounded.
  TriMesh tilted = meshes::height_field(60, 60, [](double x, double y) { return 0.3 * x - y; });
  EXPECT_LT(bending_of(tilted).bending, k_no_bending);
}

TEST(Bending, OfACylinderIsThreeTimesAreaOverSquaredRadius) {
  // 3 (k1 + k2)^2 - 8 k1 k2, whichever way the axis lies. Edges of the border count for nothing.
  for (const std::size_t cells : {30U, 60U, 120U}) {
    const double room = 1.2 / static_cast<double>(cells);
    for (const double angle : {0.0, 0.3, 0.5 * pi}) {
      const TriMesh mesh = meshes::bent_cylinder(cells, angle);
      const double area = meshes::area(mesh);
      EXPECT_NEAR(bending_of(mesh).bending / (3.0 * area / 0.25), 1.0, room)
          << cells << " " << angle;
    }
  }
}

TEST(Bending, OfASphereIsFourTimesAreaOverSquaredRadius) {
  for (const std::size_t cells : {30U, 60U, 120U}) {
    const TriMesh mesh = meshes::bent_sphere(cells);
    EXPECT_NEAR(bending_of(mesh).bending / (4.0 * meshes::area(mesh)), 1.0,
                2.4 / static_cast<double>(cells));
  }
}

TEST(Bending, OfRightTrianglesIsUpToHalfMoreThanOfEquilateralOnes) {
  // 3 k1^2 + 3 k2^2: no diagonal bends.
  EXPECT_NEAR(bending_of(solids::sphere(7.0, 40)).bending / (24.0 * pi), 1.0, 0.02);
}

TEST(Bending, DoesNotDependOnTheDensityOfTheMesh) {
  const auto check = [](const char* name, auto surface) {
    const Bending coarse = bending_of(surface(40)), middle = bending_of(surface(80)),
                  fine = bending_of(surface(160));
    for (const Bending& other : {coarse, middle}) {
      EXPECT_NEAR(other.bending / fine.bending, 1.0, 0.08) << name;
      EXPECT_NEAR(other.mean_curvature / fine.mean_curvature, 1.0, 0.08) << name;
    }
  };
  check("cylinder", [](std::size_t n) { return meshes::bent_cylinder(n, 0.2); });
  check("cone", meshes::bent_cone);
  check("sphere", meshes::bent_sphere);
  check("folded strip", meshes::folded_strip);
  check("crumpled sheet", meshes::crumpled_sheet);
}

TEST(Bending, TellsACrumpledSheetFromABentOne) {
  EXPECT_GT(bending_of(meshes::crumpled_sheet(80)).bending,
            10.0 * bending_of(meshes::bent_cylinder(80)).bending);
}

TEST(Bending, MeanCurvatureOfACylinderIsHalfItsTurnTimesItsLength) {
  // 1/2 integral |k| dA / sqrt(A) = A / (2 r) / sqrt(A).
  const TriMesh mesh = meshes::height_field(60, 60, [](double, double) { return 0.0; });
  TriMesh bent = mesh;
  for (Vec3& p : bent.positions)
    p = {30.0 * std::sin(p.x / 30.0), p.y, 30.0 * std::cos(p.x / 30.0)};
  EXPECT_NEAR(bending_of(bent).mean_curvature, 60.0 / 30.0 / 2.0, 0.02);
}

TEST(Bends, AtAVertexAreAboutOneOverTheRadius) {
  const auto check = [](const TriMesh& mesh, double expected, double room = 0.1) {
    const Patch patch(mesh);
    const std::vector<double> bends = vertex_bends(patch);
    for (const Index v : patch.inner_vertices()) {
      const auto ring = patch.ring(v);
      const bool inside =
          std::none_of(ring.begin(), ring.end(), [&](Index w) { return patch.is_border(w); });
      if (!inside) continue;
      ASSERT_NEAR(bends[v], expected, room * expected) << v;
    }
  };
  check(meshes::bent_cylinder(40, 0.5 * pi), 2.0);
  // Around the cylinder edges bend both ways.
  check(meshes::bent_cylinder(40), 2.0, 0.7);
  check(meshes::bent_sphere(40), 2.0);
  check(meshes::flat_grid(8, 5), 0.0);
}

TEST(Bending, DoesNotDependOnTheSizeOfTheModel) {
  const TriMesh mesh = meshes::rough_grid(9, 7, 4);
  const Bending figures = bending_of(mesh);
  for (const double size : {1e-150, 1e-3, 1e3, 1e150}) {
    TriMesh other = mesh;
    for (Vec3& p : other.positions)
      p = size * p;
    EXPECT_NEAR(bending_of(other).bending / figures.bending, 1.0, 1e-12) << size;
    EXPECT_NEAR(bending_of(other).mean_curvature / figures.mean_curvature, 1.0, 1e-12) << size;
  }
}

TEST(Bending, IsFiniteWhereTrianglesHaveNoArea) {
  TriMesh mesh = meshes::rough_grid(5, 5, 2);
  mesh.positions[14] = mesh.positions[15];
  EXPECT_TRUE(std::isfinite(bending_of(mesh).bending));
  for (Vec3& p : mesh.positions)
    p = {1.0, 2.0, 3.0};
  EXPECT_EQ(bending_of(mesh).bending, 0.0);
  EXPECT_EQ(bending_of(mesh).mean_curvature, 0.0);
  EXPECT_EQ(bending_of({}).bending, 0.0);
}

TEST(VertexMeanCurvatures, AreThoseOfSpheresFromBothSides) {
  TriMesh mesh = solids::sphere(7.0, 40);
  const auto mean = [](const TriMesh& of) {
    double sum = 0.0;
    const auto curvatures = vertex_mean_curvatures(Patch(of));
    for (const double curvature : curvatures)
      sum += curvature;
    return sum / static_cast<double>(curvatures.size());
  };
  EXPECT_NEAR(7.0 * mean(mesh), 1.0, 0.02);
  for (Triangle& t : mesh.triangles)
    std::swap(t[0], t[1]);
  EXPECT_NEAR(7.0 * mean(mesh), -1.0, 0.02);
}

TEST(VertexMeanCurvatures, AreHalfOneOverTheRadiusOnTubesAndNothingOnBorders) {
  const Patch patch(meshes::tube(40, 9));
  const auto curvatures = vertex_mean_curvatures(patch);
  const Vec3 p = patch.positions().front();
  const double radius = std::hypot(p.x, p.y);
  for (Index v = 0; v < patch.vertex_count(); ++v) {
    if (patch.is_inner(v)) {
      EXPECT_NEAR(radius * curvatures[v], 0.5, 0.01);
    } else {
      EXPECT_EQ(curvatures[v], 0.0);
    }
  }
}

}  // namespace
}  // namespace planish
