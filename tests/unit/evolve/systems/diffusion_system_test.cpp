#include "evolve/systems/diffusion_system.h"

#include <cmath>
#include <vector>

#include <planish/mesh/patch.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

TEST(DiffusionSystem, EndsAtTheSolutionOfTheEquationWithATensor) {
  // u = b x^2 - a y^2 solves a u_xx + b u_yy = 0, on a grid of right triangles exactly.
  const double a = 1.0, b = 0.25, height = 1e-7;
  TriMesh mesh = meshes::flat_grid(8, 8);
  const auto solution = [&](Vec3 p) { return height * (b * p.x * p.x - a * p.y * p.y); };
  for (Vec3& p : mesh.positions)
    p.z = solution(p);
  const Patch patch(mesh);
  for (const Index v : patch.inner_vertices())
    mesh.positions[v].z = 0.0;
  ThreadPool pool(1U);
  const PatchState state(Patch(mesh), pool);
  const std::vector<unsigned char> movable(state.inner_count(), 1);
  const std::vector<double> weights(state.inner_count(), 1.0);
  const DiffusionSystem system(
      state, movable, weights, 0.0,
      [&](const Triangle&) {
        return Diffusivity{{1.0, 0.0, 0.0}, a, b};
      },
      pool);
  ASSERT_TRUE(system.solvable());
  const Positions after = system.apply(inner_positions(state), pool);
  for (Index v = 0; v < state.inner_count(); ++v) {
    const Vec3 p = (1.0 / state.scale()) * after[v];
    EXPECT_NEAR(p.z, solution(mesh.positions[state.vertex_of(v)]), 1e-7 * height) << v;
  }
}

TEST(TriangleCurvature, IsThatOfACylinder) {
  const double radius = 2.0;
  const auto place = [&](double around, double along) {
    return Vec3{radius * std::sin(around), along, radius * std::cos(around)};
  };
  const auto normal = [](double around) { return Vec3{std::sin(around), 0.0, std::cos(around)}; };
  const TriangleCurvature bend =
      triangle_curvature({place(0.1, 0.0), place(0.11, 0.013), place(0.096, 0.02)},
                         {normal(0.1), normal(0.11), normal(0.096)});
  EXPECT_NEAR(bend.along, 1.0 / radius, 1e-4);
  EXPECT_NEAR(bend.across, 0.0, 1e-4);
  EXPECT_NEAR(bend.direction.y, 0.0, 1e-2);
  EXPECT_NEAR(norm(bend.direction), 1.0, 1e-12);
}

}  // namespace
}  // namespace planish
