#include <cmath>

#include <planish/measure/flattenability.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

std::vector<double> curvatures_of(const TriMesh& mesh) {
  const Patch patch(mesh);
  return gaussian_curvatures(patch, angle_defects(patch));
}

TriMesh cap_of_sphere(double radius) {
  return meshes::height_field(40, 40, [&](double x, double y) {
    return std::sqrt(radius * radius - (x - 20.0) * (x - 20.0) - (y - 20.0) * (y - 20.0));
  });
}

TEST(GaussianCurvature, OfASphereIsOneOverItsRadiusSquared) {
  constexpr double radius = 120.0;
  const TriMesh mesh = cap_of_sphere(radius);
  const auto curvatures = curvatures_of(mesh);
  EXPECT_NEAR(curvatures[20 * 41 + 20] * radius * radius, 1.0, 1e-3) << "at the top";
}

TEST(GaussianCurvature, OfASaddleIsBelowZero) {
  const TriMesh mesh = meshes::height_field(
      20, 20, [](double x, double y) { return 0.01 * (x - 10.0) * (y - 10.0); });
  EXPECT_NEAR(curvatures_of(mesh)[10 * 21 + 10], -1e-4, 1e-7);
}

TEST(GaussianCurvature, FallsWithTheSquareOfTheSize) {
  TriMesh mesh = cap_of_sphere(90.0);
  const auto small = curvatures_of(mesh);
  for (Vec3& p : mesh.positions)
    p = 1000.0 * p;
  const auto large = curvatures_of(mesh);
  for (std::size_t v = 0; v < small.size(); ++v)
    EXPECT_NEAR(1e6 * large[v], small[v], 1e-9 * std::abs(small[v]) + 1e-15);
}

TEST(GaussianCurvature, IsNothingOnTheBorderAndOnAPlane) {
  for (const double curvature : curvatures_of(meshes::flat_grid(4, 3)))
    EXPECT_EQ(curvature, 0.0);
  EXPECT_EQ(curvatures_of(cap_of_sphere(90.0)).front(), 0.0);
}

}  // namespace
}  // namespace planish
