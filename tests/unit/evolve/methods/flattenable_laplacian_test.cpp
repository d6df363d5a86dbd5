// Hard constraints that get softer where e_max would rise.

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <planish/evolve/evolve.h>
#include <planish/measure/fairness.h>

#include <gtest/gtest.h>

#include "support/bent_sheets.h"
#include "support/evolved.h"
#include "support/meshes.h"

namespace planish {
namespace {

constexpr std::size_t k_small = 14;  // cells a row: 195 inner vertices

/// Each inner vertex moved along its normal, by at(v, place) of the patch's size.
template <class At>
TriMesh perturbed(const TriMesh& smooth, const At& at) {
  const Patch patch(smooth);
  TriMesh mesh = smooth;
  for (const Index v : patch.inner_vertices()) {
    const auto ring = patch.ring(v);
    const Vec3 p = smooth.positions[v];
    const Vec3 normal = cross(smooth.positions[ring[0]] - p, smooth.positions[ring[1]] - p);
    mesh.positions[v] += (at(v) / norm(normal)) * normal;
  }
  return mesh;
}

/// Five developable surfaces, each with noise of 0.15 edges and with two bumps of 0.05.
std::vector<TriMesh> small_models() {
  std::vector<TriMesh> models;
  for (const TriMesh& smooth :
       {meshes::bent_cylinder(k_small), meshes::bent_cylinder(k_small, 0.5),
        meshes::bent_cone(k_small), meshes::bent_tangents(k_small), meshes::bent_wave(k_small)}) {
    const double edge = norm(smooth.positions[1] - smooth.positions[0]);
    meshes::Random random(7);
    models.push_back(perturbed(smooth, [&](Index) { return 0.15 * edge * random.number(); }));
    const std::size_t row = k_small + 1, rows = smooth.positions.size() / row - 1;
    models.push_back(perturbed(smooth, [&](Index v) {
      const double s = static_cast<double>(v % row) / static_cast<double>(k_small);
      const double t = static_cast<double>(v / row) / static_cast<double>(rows);
      return 0.05 * std::sin(2.0 * std::numbers::pi * s) * std::sin(std::numbers::pi * t);
    }));
  }
  return models;
}

TEST(FlattenableLaplacian, ClosesNineOfTenSmallPerturbedDevelopables) {
  // What the paper's own results end with: an e_max of up to 2e-4.
  int closed = 0;
  for (const TriMesh& mesh : small_models()) {
    const Patch before(mesh);
    const auto result =
        evolve(before, FlattenableLaplacian{}, usual_stopping(FlattenableLaplacian{}));
    const Patch after({result.positions, mesh.triangles});
    EXPECT_GT(measure(before).e_max, 0.03);
    EXPECT_LT(measure(after).e_max, measure(before).e_max);
    const double bending = measure_bending(after).bending / measure_bending(before).bending;
    closed += measure(after).e_max <= 2e-4 && bending <= 1.1 ? 1 : 0;
  }
  EXPECT_GE(closed, 9);
}

TEST(FlattenableLaplacian, NeverRaisesEMaxAboveItsStart) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    for (const double damping : {1e-9, 1e-2, 1.0}) {
      const TriMesh mesh = meshes::rough_grid(10, 10, seed, 0.3, 0.8);
      const double start = measure(Patch(mesh)).e_max;
      const auto result =
          evolve(Patch(mesh), FlattenableLaplacian{.damping = damping}, {.max_sweeps = 20});
      double last = start;
      for (const SweepRecord& record : result.history) {
        EXPECT_LE(record.e_max, std::max(last, 1.001e-4)) << seed;
        last = record.e_max;
      }
    }
  }
}

TEST(FlattenableLaplacian, LeavesWhatNoStepBetters) {
  // Flat, but for edges that are short and even the vertices would move in the plane.
  const TriMesh mesh = meshes::rough_grid(10, 10, 3, 0.25, 0.0);
  const auto result = evolve(Patch(mesh), FlattenableLaplacian{}, {.max_sweeps = 10});
  EXPECT_LE(measure(Patch({result.positions, mesh.triangles})).e_max, 1e-12);
}

}  // namespace
}  // namespace planish
