#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <planish/measure/cautions.h>

#include <gtest/gtest.h>

#include "support/bent_sheets.h"
#include "support/meshes.h"
#include "support/solids.h"

namespace planish {
namespace {

using std::numbers::pi;

constexpr double k_degree = pi / 180.0;

std::optional<CoarseFacets> facets_of(const TriMesh& mesh) {
  return find_coarse_facets(Patch(mesh));
}

/// Of a cylinder of radius 1, `angle` degrees by `facets` facets and `rows` rows.
TriMesh arc(std::size_t facets, std::size_t rows, double angle, double height = 1.0) {
  TriMesh mesh = meshes::flat_grid(facets, rows);
  for (Vec3& p : mesh.positions) {
    const double turn = angle * k_degree * p.x / static_cast<double>(facets);
    p = {std::sin(turn), height * p.y / static_cast<double>(rows), std::cos(turn)};
  }
  return mesh;
}

double chord_short_of_arc(double degrees) {
  const double angle = degrees * k_degree;
  return 1.0 - 2.0 * std::sin(0.5 * angle) / angle;
}

TEST(CoarseFacets, OfACylinderAreChordsOfItsArc) {
  // Chord and arc of 22.5 degrees: 6.4 mm in a metre.
  const auto four = facets_of(arc(4, 1, 90.0));
  ASSERT_TRUE(four);
  EXPECT_NEAR(four->turn, 22.5, 1.0 / 3.0);
  EXPECT_NEAR(1000.0 * four->shortening, 6.4, 0.2);
  for (const std::size_t facets : {6u, 8u, 12u, 16u}) {
    for (const std::size_t rows : {1u, 3u, 20u}) {
      for (const double height : {0.1, 1.0, 30.0}) {
        const double turn = 180.0 / static_cast<double>(facets);
        const auto found = facets_of(arc(facets, rows, 180.0, height));
        ASSERT_TRUE(found) << facets << " by " << rows;
        // The dihedral angle over the chord's length is a little more than the curvature.
        EXPECT_GT(found->turn, 0.999 * turn) << facets << " by " << rows;
        EXPECT_LT(found->turn, 1.02 * turn) << facets << " by " << rows;
        EXPECT_NEAR(found->shortening, chord_short_of_arc(turn), 0.04 * found->shortening);
      }
    }
  }
}

TEST(CoarseFacets, BeginAtTenDegrees) {
  EXPECT_FALSE(facets_of(arc(19, 2, 180.0)));
  EXPECT_TRUE(facets_of(arc(17, 2, 180.0)));
  EXPECT_FALSE(facets_of(meshes::bent_sphere(30)));
  EXPECT_FALSE(facets_of(meshes::bent_cone(30)));
  EXPECT_FALSE(facets_of(meshes::flat_grid(4, 4)));
}

TEST(CoarseFacets, OfASphereBoundTheShorteningOfEdges) {
  for (const Index n : {6u, 10u, 14u}) {
    TriMesh mesh = solids::sphere(1.0, n);
    mesh.triangles.resize(mesh.triangles.size() * 3 / 4);
    const Patch patch(mesh);
    const auto found = find_coarse_facets(patch);
    ASSERT_TRUE(found) << n;
    double largest = 0.0;
    for (const Edge& edge : patch.edges()) {
      const double chord = norm(mesh.positions[edge.to] - mesh.positions[edge.from]);
      largest = std::max(largest, 1.0 - chord / (2.0 * std::asin(0.5 * chord)));
    }
    EXPECT_GT(found->shortening, 0.5 * largest) << n;
    EXPECT_LT(found->shortening, 1.5 * largest) << n;
  }
}

TEST(CoarseFacets, AreNotTheCreasesOfADesign) {
  EXPECT_FALSE(facets_of(solids::cube())) << "right angles";
  const auto folded = [](double degrees, std::size_t columns) {
    TriMesh mesh = meshes::flat_grid(columns, 6);
    const double middle = 0.5 * static_cast<double>(columns);
    for (Vec3& p : mesh.positions) {
      const double beyond = std::max(0.0, p.x - middle), turn = degrees * k_degree;
      p = {p.x - beyond + beyond * std::cos(turn), p.y, beyond * std::sin(turn)};
    }
    return mesh;
  };
  for (const double degrees : {12.0, 30.0, 45.0, 60.0, 90.0}) {
    EXPECT_FALSE(facets_of(folded(degrees, 12))) << degrees;
    EXPECT_FALSE(facets_of(folded(degrees, 2))) << degrees << ", two plates";
  }
  // Pleats: creases one beside the other that turn to and fro.
  TriMesh pleats = meshes::flat_grid(24, 6);
  for (Vec3& p : pleats.positions)
    p.z = static_cast<long>(p.x) % 2 == 0 ? 0.0 : 0.3;
  EXPECT_FALSE(facets_of(pleats));
  // Chines of 60 degrees between faces that turn by 2 degrees a facet.
  TriMesh hull = meshes::flat_grid(36, 8);
  std::vector<Vec3> section = {{0.0, 0.0, 0.0}};
  for (int k = 0; k < 36; ++k) {
    const double turn = (2.0 * k + 60.0 * (k / 12)) * k_degree;
    section.push_back(section.back() + Vec3{std::cos(turn), 0.0, std::sin(turn)});
  }
  for (Vec3& p : hull.positions)
    p = section[static_cast<std::size_t>(p.x)] + Vec3{0.0, p.y, 0.0};
  EXPECT_FALSE(facets_of(hull));
}

TEST(CoarseFacets, DoNotDependOnSize) {
  TriMesh mesh = arc(8, 3, 180.0);
  const double turn = facets_of(mesh)->turn;
  for (Vec3& p : mesh.positions)
    p = 1e120 * p;
  EXPECT_NEAR(facets_of(mesh)->turn, turn, 1e-9);
}

}  // namespace
}  // namespace planish
