#include <cmath>
#include <numbers>

#include <planish/core/error.h>
#include <planish/evolve/evolve.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "evolve/state/patch_state.h"
#include "oracle/plain.h"
#include "support/meshes.h"

namespace planish {
namespace {

constexpr LineSolver k_solvers[] = {LineSolver::model, LineSolver::trust_region};

double energy_of(const TriMesh& mesh) {
  return measure(Patch(mesh)).energy;
}

TriMesh evolved(const TriMesh& mesh, const Method& method, int sweeps, unsigned threads = 1) {
  return {evolve(Patch(mesh), method, {.max_sweeps = sweeps}, {}, {.threads = threads}).positions,
          mesh.triangles};
}

/// The order in which the library visits the inner vertices.
std::vector<Index> visiting_order(const TriMesh& mesh) {
  const Patch patch(mesh);
  ThreadPool pool(1);
  const PatchState state(patch, pool);
  std::vector<Index> order;
  for (std::size_t v = 0; v < state.inner_count(); ++v)
    order.push_back(state.vertex_of(state.plan().visits[v]));
  return order;
}

TEST(Controllable, TakesThePathOfThePlainImplementation) {
  for (const char* name : {"panel", "dome", "saddle"}) {
    const TriMesh mesh = make_shape(name, 150);
    for (const double lambda_min : {0.0, -0.2}) {
      plain::Patch patch(mesh);
      const auto order = visiting_order(mesh);
      for (int sweep = 0; sweep < 4; ++sweep) {
        patch.controllable_sweep(order, {lambda_min, 1.0}, 1e-17);
      }
      const TriMesh ours =
          evolved(mesh, ControllableLaplacian{.lambda_min = lambda_min, .min_angle = 0.0}, 4);
      double apart = 0.0;
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        apart = std::max(apart, norm(ours.positions[v] - patch.mesh.positions[v]));
      }
      // The search divides differences of b by small steps, and so errors of rounding grow; most
      // where steps of both signs end near 0.
      const double bound = lambda_min < 0.0 ? 1e-8 : 1e-9;
      EXPECT_LT(apart, bound * bounding_box_diagonal(mesh)) << name << " " << lambda_min;
    }
  }
}

TEST(Controllable, StepsAreTheBestOfTheirLinesButForAFewOnWildRings) {
  int steps = 0, missed = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const plain::Patch patch(meshes::rough_grid(9, 9, seed, 0.3, 0.6));
    for (Index v = 0; v < patch.inner.size(); ++v) {
      if (!patch.inner[v]) continue;
      const Vec3 L = patch.laplacian(v), x = patch.mesh.positions[v];
      const auto f = [&](double lambda) { return patch.ring_energy(v, x + lambda * L); };
      const plain::Found found = plain::search_on_line(patch.defects_along(v, L), f, {0.0, 1.0});
      if (found.at == 0.0) continue;
      ++steps;
      // The minimum is within a few thousandths if no place beside is lower.
      const auto is_lower = [&](double lambda) {
        return lambda >= 0.0 && lambda <= 1.0 && f(lambda) < found.value;
      };
      if (is_lower(found.at - 0.005) || is_lower(found.at + 0.005)) ++missed;
    }
  }
  EXPECT_GT(steps, 300);
  EXPECT_LT(missed, 0.03 * steps);
}

TEST(Controllable, EnergyNeverRisesInASweep) {
  for (const LineSolver solver : k_solvers) {
    for (const double lambda_min : {0.0, -1.0}) {
      for (std::uint64_t seed = 0; seed < 4; ++seed) {
        const TriMesh mesh = meshes::rough_grid(12, 12, seed, 0.3, 0.6);
        double energy = energy_of(mesh);
        const ControllableLaplacian options{.lambda_min = lambda_min, .solver = solver};
        const auto result = evolve(Patch(mesh), options, {.max_sweeps = 40});
        for (const SweepRecord& record : result.history) {
          EXPECT_LE(record.energy, energy);
          energy = record.energy;
        }
      }
    }
  }
}

TEST(Controllable, RecordsWhatMeasuringSays) {
  const TriMesh mesh = meshes::rough_grid(10, 10, 3);
  const EvolveResult result = evolve(Patch(mesh), ControllableLaplacian{}, {.max_sweeps = 5});
  const TriMesh after{result.positions, mesh.triangles};
  const Flattenability figures = measure(Patch(after));
  ASSERT_EQ(result.history.size(), 5U);
  EXPECT_EQ(result.history.back().energy, figures.energy);
  EXPECT_EQ(result.history.back().e_max, figures.e_max);
  EXPECT_EQ(result.history.back().e_avg, figures.e_avg);
  EXPECT_EQ(result.history.back().sweep, 5);
}

TEST(Controllable, NeverMovesTheBorderNorUnusedVertices) {
  TriMesh mesh = meshes::rough_grid(8, 8, 1);
  mesh.positions.push_back({1e9, 0.1, 0.3});
  const Patch patch(mesh);
  const TriMesh after = evolved(mesh, ControllableLaplacian{.lambda_min = -1.0}, 10);
  ASSERT_EQ(after.positions.size(), mesh.positions.size());
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    if (!patch.is_inner(v)) {
      EXPECT_EQ(after.positions[v], mesh.positions[v]) << v;
    }
  }
}

TEST(Controllable, GivesTheSameBitsOnAnyNumberOfThreads) {
  for (const char* name : {"panel", "dome"}) {
    const TriMesh mesh = make_shape(name, 6'000);
    for (const LineSolver solver : k_solvers) {
      const ControllableLaplacian options{.solver = solver};
      const TriMesh one = evolved(mesh, options, 3, 1);
      for (const unsigned threads : {2U, 4U})
        EXPECT_EQ(evolved(mesh, options, 3, threads).positions, one.positions);
    }
  }
}

TEST(Controllable, LeavesFlattenableSurfacesAsTheyAre) {
  for (const Shape& shape : shapes()) {
    if (!shape.flattenable) continue;
    const TriMesh mesh = make_shape(shape.name, 1500);
    const Patch patch(mesh);
    for (const ControllableLaplacian& options :
         {ControllableLaplacian{}, ControllableLaplacian{.lambda_min = -1.0},
          ControllableLaplacian{.lambda_min = -1.0, .solver = LineSolver::trust_region}}) {
      Evolver evolver(patch, options);
      for (int sweep = 0; sweep < 3; ++sweep)
        EXPECT_EQ(evolver.step().moved, 0U) << shape.name;
      EXPECT_EQ(evolver.positions(), mesh.positions);
    }
  }
}

TEST(Controllable, BringsTheApexOfAPyramidIntoThePlane) {
  for (const std::size_t valence : {3U, 4U, 5U, 6U, 9U, 300U}) {
    const TriMesh mesh = meshes::fan(valence, 0.5);
    for (const LineSolver solver : k_solvers) {
      const TriMesh after = evolved(mesh, ControllableLaplacian{.solver = solver}, 60);
      EXPECT_LT(std::abs(after.positions[0].z), 1e-4) << valence;
      EXPECT_LT(energy_of(after), 1e-15) << valence;
    }
  }
}

TEST(Controllable, HardlyHelpsASaddleUnlessLambdaMayBeNegative) {
  // A hyperbolic paraboloid over equilateral triangles: the paper's Fig. 11.
  TriMesh mesh = meshes::flat_grid(20, 20);
  for (Vec3& p : mesh.positions) {
    const double x = (p.x - 0.5 * p.y) / 20.0, y = p.y * std::sqrt(0.75) / 20.0;
    p = {x, y, 0.4 * x * y};
  }
  const double before = energy_of(mesh);
  EXPECT_GT(energy_of(evolved(mesh, ControllableLaplacian{}, 50)), 0.99 * before);
  EXPECT_LT(energy_of(evolved(mesh, ControllableLaplacian{.lambda_min = -1.0}, 50)), 0.99 * before);
}

TEST(Controllable, LeavesASaddleInsideTheHullOfItsRingWhereItIs) {
  // There the angle sum is above 2 pi at every point on the way to the Laplacian's end.
  for (const std::size_t valence : {4U, 6U, 8U}) {
    const TriMesh saddle = meshes::ruffled_fan(valence, 0.3);
    for (const LineSolver solver : k_solvers) {
      const ControllableLaplacian options{.solver = solver};
      EXPECT_EQ(evolved(saddle, options, 5).positions, saddle.positions);
    }
  }
}

TEST(Controllable, WithNegativeStepsGetsFurtherAndKeepsTheSmallestAngle) {
  const TriMesh mesh = make_shape("panel", 1000);
  const Flattenability before = measure(Patch(mesh));
  const TriMesh forward = evolved(mesh, ControllableLaplacian{}, 30);
  for (const LineSolver solver : k_solvers) {
    const ControllableLaplacian options{.lambda_min = -1.0, .min_angle = 5.0, .solver = solver};
    const TriMesh both = evolved(mesh, options, 30);
    const Flattenability after = measure(Patch(both));
    EXPECT_LT(after.energy, energy_of(forward));
    EXPECT_GE(after.min_angle, std::min(before.min_angle, 5.0 * std::numbers::pi / 180.0) - 1e-12);
  }
}

TEST(Controllable, KeepsEveryVertexWithinTheDeviation) {
  const TriMesh mesh = meshes::rough_grid(12, 12, 6, 0.2, 0.6);
  for (const double limit : {0.0, 0.01, 0.1}) {
    for (const Method& method :
         {Method{ControllableLaplacian{.max_deviation = limit}},
          Method{ControllableLaplacian{.lambda_min = -1.0, .max_deviation = limit}},
          Method{ControllableLaplacian{
              .lambda_min = -1.0, .max_deviation = limit, .solver = LineSolver::trust_region}},
          Method{ClassicalLaplacian{.max_deviation = limit}}}) {
      const TriMesh after = evolved(mesh, method, 20);
      double farthest = 0.0;
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        farthest = std::max(farthest, norm(after.positions[v] - mesh.positions[v]));
      }
      EXPECT_LE(farthest, limit) << name_of(method);
      if (limit > 0.0) {
        EXPECT_GT(farthest, 0.9 * limit) << name_of(method);
      }
    }
  }
}

TEST(Controllable, DoesNotDependOnTheSizeOfTheModel) {
  const TriMesh mesh = meshes::rough_grid(10, 10, 12);
  for (const LineSolver solver : k_solvers) {
    const ControllableLaplacian options{.solver = solver};
    const TriMesh after = evolved(mesh, options, 5);
    for (const double size : {0x1p-400, 0x1p+40, 0x1p+700}) {
      TriMesh scaled = mesh;
      for (Vec3& p : scaled.positions)
        p = size * p;
      const TriMesh scaled_after = evolved(scaled, options, 5);
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        ASSERT_EQ(scaled_after.positions[v], size * after.positions[v]) << size;
      }
    }
  }
}

TEST(Controllable, SurvivesASpikeAMillionTimesTheSizeOfThePatch) {
  TriMesh mesh = meshes::rough_grid(8, 8, 2);
  mesh.positions[40] = {1e6, -2e6, 3e6};
  for (const LineSolver solver : k_solvers) {
    const ControllableLaplacian options{.solver = solver};
    const EvolveResult result = evolve(Patch(mesh), options, {.max_sweeps = 20});
    double energy = energy_of(mesh);
    for (const SweepRecord& record : result.history) {
      EXPECT_LE(record.energy, energy);
      energy = record.energy;
    }
    for (const Vec3 p : result.positions)
      EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
  }
}

}  // namespace
}  // namespace planish
