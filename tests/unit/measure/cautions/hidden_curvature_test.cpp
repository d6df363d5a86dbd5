#include <cmath>
#include <numbers>
#include <utility>

#include <planish/measure/cautions.h>

#include <gtest/gtest.h>

#include "support/bent_sheets.h"
#include "support/meshes.h"
#include "support/solids.h"

namespace planish {
namespace {

std::optional<HiddenCurvature> hidden_in(const TriMesh& mesh) {
  return find_hidden_curvature(Patch(mesh));
}

/// A grid of `rows` rows over [0, 1] x [0, 1], each vertex where place(u, v) has it.
template <class Place>
TriMesh strip(std::size_t columns, std::size_t rows, Place place) {
  TriMesh mesh = meshes::flat_grid(columns, rows);
  for (Vec3& p : mesh.positions)
    p = place(p.x / static_cast<double>(columns), p.y / static_cast<double>(rows));
  return mesh;
}

Vec3 on_cylinder(double u, double v) {
  return {std::cos(2.0 * u), 3.0 * v, std::sin(2.0 * u)};
}

Vec3 on_hypar(double u, double v) {
  return {u, v, (u - 0.5) * (v - 0.5)};
}

/// Between a line and an arc, its rulings parallel to a plane.
Vec3 on_conoid(double u, double v) {
  return {u, v, v * std::sin(std::numbers::pi * u)};
}

Vec3 on_sphere(double u, double v) {
  const double x = u - 0.5, y = 0.4 * v;
  return {x, y, std::sqrt(1.0 - x * x - y * y)};
}

TEST(HiddenCurvature, OfOneRowOfTwistedFacetsIsFound) {
  for (const auto place : {on_hypar, on_conoid, on_sphere}) {
    const auto hidden = hidden_in(strip(20, 1, place));
    ASSERT_TRUE(hidden);
    EXPECT_EQ(hidden->inner_share, 0.0);
  }
  EXPECT_TRUE(hidden_in(strip(1, 1, on_hypar))) << "two triangles";
}

/// One row of quadrangles whose diagonals go up and down in turn.
template <class Place>
TriMesh zigzag(std::size_t columns, Place place) {
  TriMesh mesh;
  const auto count = static_cast<double>(columns);
  for (std::size_t k = 0; k <= columns; ++k) {
    for (const double v : {0.0, 1.0})
      mesh.positions.push_back(place(static_cast<double>(k) / count, v));
  }
  for (Index k = 0; k < columns; ++k) {
    const Index a = 2 * k, b = a + 2, c = a + 3, d = a + 1;
    if (k % 2 == 0) {
      mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}});
    } else {
      mesh.triangles.insert(mesh.triangles.end(), {{a, b, d}, {b, c, d}});
    }
  }
  return mesh;
}

// Of a hyperbolic paraboloid two triangles beside a cross edge are in one plane: its edges are
// straight lines of the surface.
TEST(HiddenCurvature, OfDiagonalsInZigzagIsFound) {
  for (const std::size_t columns : {4u, 7u, 20u}) {
    for (const auto place : {on_hypar, on_conoid, on_sphere})
      EXPECT_TRUE(hidden_in(zigzag(columns, place))) << columns;
    EXPECT_FALSE(hidden_in(zigzag(columns, on_cylinder))) << columns;
    EXPECT_FALSE(hidden_in(zigzag(columns, [](double u, double v) {
      return Vec3{u, v, 0.0};
    }))) << columns;
  }
  EXPECT_TRUE(hidden_in(zigzag(10, [](double u, double v) {
    const double turn = 1.5 * u;  // bent and twisted
    return Vec3{std::cos(u) + v * std::cos(turn), std::sin(u), v * std::sin(turn)};
  })));
}

TEST(HiddenCurvature, IsNoneOfPlaneFacetsThatAreMeantAsSuch) {
  // A cone whose rulings have a vertex between: its tip is on the border.
  TriMesh fan;
  fan.positions.push_back({0.0, 0.0, 0.0});
  for (int k = 0; k <= 8; ++k) {
    for (const double r : {0.5, 1.0})
      fan.positions.push_back({r * std::cos(0.25 * k), r * std::sin(0.25 * k), r});
  }
  for (Index k = 0; k < 8; ++k) {
    const Index a = 1 + 2 * k, b = a + 1, c = a + 3, d = a + 2;
    fan.triangles.insert(fan.triangles.end(), {{0, a, d}, {a, b, c}, {a, c, d}});
  }
  EXPECT_FALSE(hidden_in(fan));
  // Two triangular plates with vertices inside, folded at their common edge, and a third.
  TriMesh plates;
  plates.positions = {{0, 0, 0}, {4, 0, 0},
                      {2, 3, 0}, {2, 1, 0},
                      {5, 3, 1}, {11.0 / 3, 2, 1.0 / 3},
                      {7, 0, 3}, {16.0 / 3, 1, 4.0 / 3}};
  const auto plate = [&](Index a, Index b, Index c, Index middle) {
    for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
      plates.triangles.push_back({from, to, middle});
  };
  plate(0, 1, 2, 3);
  plate(2, 1, 4, 5);
  plate(4, 1, 6, 7);
  EXPECT_FALSE(hidden_in(plates));
}

TEST(HiddenCurvature, IsNoneWhereTheCrossEdgesAreRulings) {
  EXPECT_FALSE(hidden_in(strip(10, 1, on_cylinder)));
  EXPECT_FALSE(hidden_in(meshes::tube(12, 1))) << "open at both ends";
  EXPECT_FALSE(hidden_in(strip(10, 1, [](double u, double v) {
    const double r = 1.0 + v;
    return Vec3{r * std::cos(2.0 * u), r * std::sin(2.0 * u), r};
  }))) << "a frustum";
  EXPECT_FALSE(hidden_in(strip(10, 2, on_cylinder))) << "plane facets of two rows";
}

TEST(HiddenCurvature, IsNoneOfRulingsThatMeetOnTheBorder) {
  TriMesh fan;  // a sector of a cone
  fan.positions.push_back({0.0, 0.0, 0.0});
  for (int k = 0; k <= 8; ++k)
    fan.positions.push_back({std::cos(0.25 * k), std::sin(0.25 * k), 1.0});
  for (Index k = 1; k <= 8; ++k)
    fan.triangles.push_back({0, k, k + 1});
  EXPECT_FALSE(hidden_in(fan));
  EXPECT_TRUE(hidden_in(meshes::fan(8, 0.5)))
      << "the tip inside: a cone, or a dome with one vertex";
}

/// A half or the whole of a square of 240 that goes over into a circle of radius 60: the cone of a
/// corner for each quarter, and plane triangles between them and at both ends.
TriMesh square_to_round(Index quarters, Index facets_of_cone) {
  const Vec3 corners[] = {
      {120, 0, 0}, {120, 120, 0}, {-120, 120, 0}, {-120, -120, 0}, {120, -120, 0}};
  const Index arc = quarters * facets_of_cone;
  TriMesh mesh;
  for (Index k = 0; k <= arc; ++k) {
    const double angle = std::numbers::pi / 2.0 * k / facets_of_cone;
    mesh.positions.push_back({60.0 * std::cos(angle), 60.0 * std::sin(angle), 100.0});
  }
  for (Index k = 0; k <= quarters; ++k)
    mesh.positions.push_back(corners[k]);
  mesh.positions.push_back({quarters == 2 ? -120.0 : 120.0, 0, 0});
  const Index first = arc + 1;
  for (Index k = 0; k < arc; ++k)
    mesh.triangles.push_back({first + 1 + k / facets_of_cone, k + 1, k});
  for (Index k = 0; k <= quarters; ++k)
    mesh.triangles.push_back({first + k, first + k + 1, k * facets_of_cone});
  return mesh;
}

TEST(HiddenCurvature, IsNoneOfASquareThatGoesOverIntoACircle) {
  for (const Index quarters : {2u, 4u}) {
    for (const Index facets : {4u, 8u, 16u})
      EXPECT_FALSE(hidden_in(square_to_round(quarters, facets))) << quarters << " " << facets;
  }
}

// Of two borders with different numbers of vertices, fans are left that turn little.
TEST(HiddenCurvature, OfALoftWithFansIsFound) {
  constexpr Index k_fans = 10, k_facets = 4;
  TriMesh loft;
  for (Index k = 0; k <= k_fans * k_facets; ++k)
    loft.positions.push_back(on_conoid(static_cast<double>(k) / (k_fans * k_facets), 1.0));
  const auto first = static_cast<Index>(loft.positions.size());
  for (Index k = 0; k <= k_fans; ++k)
    loft.positions.push_back(on_conoid(static_cast<double>(k) / k_fans, 0.0));
  for (Index k = 0; k < k_fans; ++k) {
    for (Index i = 0; i < k_facets; ++i)
      loft.triangles.push_back({first + k, k * k_facets + i + 1, k * k_facets + i});
    loft.triangles.push_back({first + k, first + k + 1, (k + 1) * k_facets});
  }
  EXPECT_TRUE(hidden_in(loft));
}

TEST(HiddenCurvature, IsNoneOfPlanesAndFoldedPlates) {
  EXPECT_FALSE(hidden_in(meshes::flat_grid(5, 1)));
  EXPECT_FALSE(hidden_in(meshes::flat_grid(1, 1)));
  EXPECT_FALSE(hidden_in(meshes::fan(6))) << "plane with one vertex inside";
  EXPECT_FALSE(hidden_in(strip(3, 1, [](double u, double v) {
    return Vec3{u, v, u > 0.5 ? 2.0 * u : 1.0};
  }))) << "a plate with a flange";
  TriMesh open = solids::cube();
  open.triangles.resize(open.triangles.size() - 2);  // a box without its lid
  EXPECT_FALSE(hidden_in(open));
}

TEST(HiddenCurvature, IsJudgedByTheAreaAroundInnerVertices) {
  const auto two = hidden_in(strip(20, 2, on_sphere));
  ASSERT_TRUE(two);
  EXPECT_NEAR(two->inner_share, 19.0 / 40.0, 0.01);
  EXPECT_FALSE(hidden_in(strip(20, 3, on_sphere))) << "two thirds of it are around inner vertices";
  EXPECT_FALSE(hidden_in(meshes::bent_sphere(12)));
}

TEST(HiddenCurvature, DoesNotDependOnSizeAndPlace) {
  for (const double size : {1e-150, 1e3, 1e150}) {
    TriMesh twisted = strip(20, 1, on_hypar), ruled = strip(10, 1, on_cylinder);
    for (TriMesh* mesh : {&twisted, &ruled}) {
      for (Vec3& p : mesh->positions)
        p = size * (p + Vec3{3.0, -2.0, 5.0});
    }
    EXPECT_TRUE(hidden_in(twisted)) << size;
    EXPECT_FALSE(hidden_in(ruled)) << size;
  }
}

}  // namespace
}  // namespace planish
