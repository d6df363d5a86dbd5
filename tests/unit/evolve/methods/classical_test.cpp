#include <planish/evolve/evolve.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "evolve/state/patch_state.h"
#include "oracle/plain.h"
#include "support/meshes.h"

namespace planish {
namespace {

double farthest(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double distance = 0.0;
  for (std::size_t v = 0; v < a.size(); ++v)
    distance = std::max(distance, norm(a[v] - b[v]));
  return distance;
}

TEST(Classical, SimultaneousIsEquation10AtAllVerticesAtOnce) {
  const TriMesh mesh = meshes::rough_grid(9, 9, 5);
  plain::Patch patch(mesh);
  for (int sweep = 0; sweep < 3; ++sweep) {
    std::vector<Vec3> next = patch.mesh.positions;
    for (Index v = 0; v < next.size(); ++v) {
      if (patch.inner[v]) next[v] += 0.3 * patch.laplacian(v);
    }
    patch.mesh.positions = next;
  }
  const auto result =
      evolve(Patch(mesh), ClassicalLaplacian{.lambda = 0.3, .order = SweepOrder::simultaneous},
             {.max_sweeps = 3});
  EXPECT_LT(farthest(result.positions, patch.mesh.positions), 1e-13);
}

TEST(Classical, SequentialSeesTheMovesMadeBefore) {
  const TriMesh mesh = meshes::rough_grid(9, 9, 6);
  const Patch surface(mesh);
  ThreadPool pool(1);
  const PatchState state(surface, pool);
  plain::Patch patch(mesh);
  for (std::size_t v = 0; v < state.inner_count(); ++v) {
    const Index vertex = state.vertex_of(state.plan().visits[v]);
    patch.mesh.positions[vertex] += 0.5 * patch.laplacian(vertex);
  }
  const auto result = evolve(surface, ClassicalLaplacian{}, {.max_sweeps = 1});
  EXPECT_LT(farthest(result.positions, patch.mesh.positions), 1e-13);
}

TEST(Classical, MayRaiseTheEnergyAsThePaperShows) {
  // One vertex lifted out of a plane: the others are dragged along.
  TriMesh mesh = meshes::ruffled_fan(8, 0.3);
  mesh.positions[0].z = 0.2;
  const double before = measure(Patch(mesh)).energy;
  const auto result = evolve(Patch(mesh), ClassicalLaplacian{}, {.max_sweeps = 20});
  EXPECT_GT(result.history.back().energy, before);
}

TEST(Classical, GivesTheSameBitsOnAnyNumberOfThreads) {
  const TriMesh mesh = make_shape("panel", 10'000);
  for (const auto& order : k_sweep_orders) {
    const ClassicalLaplacian method{.order = order.first};
    const auto one = evolve(Patch(mesh), method, {.max_sweeps = 3}, {}, {.threads = 1});
    EXPECT_EQ(evolve(Patch(mesh), method, {.max_sweeps = 3}, {}, {.threads = 4}).positions,
              one.positions);
  }
}

TEST(Classical, NeverMovesTheBorder) {
  const TriMesh mesh = meshes::rough_grid(7, 7, 2);
  const Patch patch(mesh);
  const auto result = evolve(patch, ClassicalLaplacian{.lambda = 1.0});
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    if (!patch.is_inner(v)) {
      EXPECT_EQ(result.positions[v], mesh.positions[v]);
    }
  }
}

}  // namespace
}  // namespace planish
