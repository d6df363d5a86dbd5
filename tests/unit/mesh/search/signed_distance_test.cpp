#include "mesh/search/signed_distance.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <planish/core/error.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/solids.h"

namespace planish {
namespace {

/// Of the cube from -1 to 1.
double distance_from_cube(Vec3 p) {
  const Vec3 over{std::abs(p.x) - 1.0, std::abs(p.y) - 1.0, std::abs(p.z) - 1.0};
  const double most = std::max({over.x, over.y, over.z});
  if (most <= 0.0) return most;
  return norm(Vec3{std::max(over.x, 0.0), std::max(over.y, 0.0), std::max(over.z, 0.0)});
}

/// How often the surface is wound around p: 1 inside, 0 outside. By solid angles.
double winding_number(const TriMesh& surface, Vec3 p) {
  double sum = 0.0;
  for (const Triangle& t : surface.triangles) {
    const Vec3 a = surface.positions[t[0]] - p, b = surface.positions[t[1]] - p,
               c = surface.positions[t[2]] - p;
    const double la = norm(a), lb = norm(b), lc = norm(c);
    sum += 2.0 * std::atan2(dot(a, cross(b, c)),
                            la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
  }
  return sum / (4.0 * std::numbers::pi);
}

TEST(SignedDistance, OfACubeIsItsFormula) {
  const SignedDistance distance(solids::cube());
  meshes::Random random(1);
  for (int round = 0; round < 2000; ++round) {
    const Vec3 p = meshes::random_point(random, 2.0);
    EXPECT_NEAR(distance.at(p).value, distance_from_cube(p), 1e-14);
  }
}

TEST(SignedDistance, HasTheRightSignNearEdgesAndCornersOfANonConvexPrism) {
  const TriMesh prism = solids::star_prism();
  const SignedDistance distance(prism);
  meshes::Random random(2);
  int inside = 0;
  for (const Vec3 corner : prism.positions) {
    for (int round = 0; round < 400; ++round) {
      const Vec3 p = corner + meshes::random_point(random, round % 2 == 0 ? 0.05 : 0.5);
      const double winding = winding_number(prism, p);
      EXPECT_EQ(distance.at(p).value<0.0, winding> 0.5);
      inside += winding > 0.5;
    }
  }
  EXPECT_GT(inside, 1000);
  // Near the middles of edges too.
  for (const Triangle& t : prism.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3 middle = 0.5 * (prism.positions[t[k]] + prism.positions[t[(k + 1) % 3]]);
      for (int round = 0; round < 50; ++round) {
        const Vec3 p = middle + meshes::random_point(random, 0.05);
        EXPECT_EQ(distance.at(p).value<0.0, winding_number(prism, p)> 0.5);
      }
    }
  }
}

TEST(SignedDistance, GrowsAlongItsGradient) {
  const SignedDistance distance(solids::star_prism());
  meshes::Random random(3);
  constexpr double h = 1e-6;
  for (int round = 0; round < 500; ++round) {
    const Vec3 p = meshes::random_point(random, 1.5);
    const Distance at = distance.at(p);
    EXPECT_NEAR(norm(at.gradient), 1.0, 1e-14);
    // Where the closest point jumps there is no gradient; it has measure zero.
    const double more = distance.at(p + h * at.gradient).value;
    const double less = distance.at(p - h * at.gradient).value;
    EXPECT_NEAR((more - less) / (2.0 * h), 1.0, 1e-6);
  }
}

TEST(SignedDistance, OnTheSurfaceIsNothingAndTheNormalTellsTheWayOut) {
  const SignedDistance distance(solids::cube());
  const Distance face = distance.at({0.3, 0.2, 1.0});
  EXPECT_NEAR(face.value, 0.0, 1e-15);
  EXPECT_LT(norm(face.gradient - Vec3{0, 0, 1}), 1e-15);
  const Distance edge = distance.at({1.0, 0.25, 1.0});
  EXPECT_LT(norm(edge.gradient - Vec3{std::sqrt(0.5), 0, std::sqrt(0.5)}), 1e-15);
  // Whichever way the faces are cut into triangles.
  const double third = std::sqrt(1.0 / 3.0);
  EXPECT_LT(norm(distance.at({1, 1, 1}).gradient - Vec3{third, third, third}), 1e-15);
  EXPECT_LT(norm(distance.at({1, -1, 1}).gradient - Vec3{third, -third, third}), 1e-15);
}

TEST(RequireClosed, RefusesWhatHasNoInside) {
  const auto error_of = [](const TriMesh& surface) {
    try {
      require_closed(surface, "obstacle");
    } catch (const Error& error) {
      EXPECT_EQ(error.message().rfind("obstacle: ", 0), 0U) << error.message();
      return std::string(to_string(error.code()));
    }
    return std::string();
  };
  EXPECT_EQ(error_of(solids::cube()), "");
  EXPECT_EQ(error_of(solids::star_prism()), "");
  EXPECT_EQ(error_of(meshes::side_by_side(solids::cube(), solids::sphere(1.0, 8))), "");
  // The torus of the tests is inside out.
  EXPECT_EQ(error_of(meshes::torus(8, 9)), "inconsistent_orientation");
  EXPECT_EQ(error_of(meshes::flat_grid(3, 3)), "open_surface");
  EXPECT_EQ(error_of({}), "no_triangles");
  TriMesh mesh = solids::cube();
  for (Triangle& t : mesh.triangles)
    std::swap(t[0], t[1]);
  EXPECT_EQ(error_of(mesh), "inconsistent_orientation");
  mesh = solids::cube();
  std::swap(mesh.triangles[3][0], mesh.triangles[3][1]);
  EXPECT_EQ(error_of(mesh), "inconsistent_orientation");
  mesh = solids::cube();
  mesh.triangles.pop_back();
  EXPECT_EQ(error_of(mesh), "open_surface");
  mesh = solids::cube();
  mesh.positions[3].x = std::nan("");
  EXPECT_EQ(error_of(mesh), "non_finite_coordinate");
  mesh = meshes::tetrahedron();
  mesh.positions[3] = {0.5, 0.5, 0.0};
  EXPECT_EQ(error_of(mesh), "zero_area");
}

}  // namespace
}  // namespace planish
