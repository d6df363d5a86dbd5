#include <cmath>
#include <string>

#include <planish/evolve/evolve.h>
#include <planish/measure/deviation.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/shapes.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

#include <gtest/gtest.h>

#include "evolve/auto/shared/coarse_levels.h"
#include "evolve/systems/positions.h"
#include "support/evolved.h"

namespace planish {
namespace {

/// The way that stays near; the other ways are in smooth/smooth_auto_test.cpp.
constexpr Auto k_near{.prefer = Prefer::near};

EvolveResult run(const TriMesh& mesh, Auto method = {}, const Constraints& constraints = {},
                 unsigned threads = 0) {
  method.prefer = Prefer::near;
  return evolve(Patch(mesh), method, usual_stopping(method), constraints, {.threads = threads});
}

TEST(Auto, MakesShapesFlattenableWithoutNeedles) {
  for (const char* shape : {"panel", "saddle"}) {
    const TriMesh mesh = make_shape(shape, 1500);
    const EvolveResult result = run(mesh);
    EXPECT_EQ(result.stop, StopReason::converged) << shape;
    const Flattenability before = measure(Patch(mesh));
    const Flattenability after = figures_of(mesh, result.positions);
    EXPECT_LE(after.e_max, k_flattenable_e_max) << shape;
    EXPECT_LE(after.sum_abs_defect, k_flattenable_sum) << shape;
    EXPECT_GE(after.min_angle, 0.5 * before.min_angle) << shape;
    // The saddle is steep: to lie flat within its border it must wave.
    if (shape == std::string("panel")) {
      EXPECT_LE(after.roughness, 2.0 * before.roughness + 3.0);
    }
  }
}

TEST(Auto, GoesFromCoarseToFineWithTheSameBitsOnAnyNumberOfThreads) {
  const TriMesh mesh = make_shape("panel", 6500);
  const EvolveResult first = run(mesh, {}, {}, 1), again = run(mesh, {}, {}, 3);
  EXPECT_EQ(first.positions, again.positions);
  EXPECT_EQ(first.stop, StopReason::converged);
  EXPECT_LE(figures_of(mesh, first.positions).e_max, k_flattenable_e_max);
  ASSERT_TRUE(first.history.front().level.has_value());
  EXPECT_LT(first.history.front().level->inner_vertices, 3000U);
  EXPECT_EQ(first.history.front().moved > 0, true);
  EXPECT_FALSE(first.history.back().level.has_value());
  for (const SweepRecord& record : first.history) {
    if (record.level && record.moved > 0) {
      EXPECT_LT(record.level->merit, record.level->merit_before) << record.sweep;
    }
  }
}

TEST(Auto, KeepsWhatCoarseLevelsFoundAtTheLimitOfSweeps) {
  const TriMesh mesh = make_shape("panel", 6500);
  const EvolveResult result = evolve(Patch(mesh), k_near, {.max_sweeps = 6});
  EXPECT_EQ(result.stop, StopReason::sweep_limit);
  EXPECT_NE(result.positions, mesh.positions);
  // The border stays, and the strain that it is after fell, so the total curvature did.
  const Patch patch(mesh);
  for (const auto& loop : patch.border_loops()) {
    for (const Index v : loop)
      EXPECT_EQ(result.positions[v], mesh.positions[v]);
  }
  EXPECT_LT(figures_of(mesh, result.positions).sum_abs_defect, measure(patch).sum_abs_defect);
}

TEST(Auto, EndsWhenTheStrainIsMetWithLessDeviation) {
  const TriMesh mesh = make_shape("panel", 600);
  const Patch patch(mesh);
  double last = std::numeric_limits<double>::infinity(), farthest = 0.0;
  const auto far = [&](const EvolveResult& result) {
    return measure_deviation(patch, result.positions).rms;
  };
  for (const double strain : {0.02, 0.01, 0.005}) {
    const EvolveResult result = run(mesh, {.limits = {.max = strain}});
    EXPECT_EQ(result.stop, StopReason::strain_met) << strain;
    const TriMesh moved{result.positions, mesh.triangles};
    const double left = edge_strain(Patch(moved), unfold(Patch(moved)).positions).rms;
    EXPECT_LT(left, last) << strain;
    last = left;
    EXPECT_GT(far(result), farthest) << strain;
    farthest = far(result);
  }
  EXPECT_LT(farthest, far(run(mesh)));
}

TEST(Auto, KeepsALimitOfTheRmsOfStrain) {
  const TriMesh mesh = make_shape("panel", 900);
  const Patch patch(mesh);
  double last = std::numeric_limits<double>::infinity(), farthest = 0.0;
  for (const double limit : {0.006, 0.003, 0.0015}) {
    const EvolveResult result = run(mesh, {.limits = {.rms = limit}});
    EXPECT_EQ(result.stop, StopReason::strain_met) << limit;
    const TriMesh moved{result.positions, mesh.triangles};
    const EdgeStrain left = edge_strain(Patch(moved), unfold(Patch(moved)).positions);
    EXPECT_LE(left.rms, limit);
    EXPECT_GT(left.rms, 0.8 * limit) << "it goes no further than it need";
    EXPECT_LT(left.rms, last) << limit;
    last = left.rms;
    const double far = measure_deviation(patch, result.positions).rms;
    EXPECT_GT(far, farthest) << limit;
    farthest = far;
  }
  // Both limits: the stricter one decides.
  const auto positions = [&](const Auto& method) { return run(mesh, method).positions; };
  EXPECT_EQ(positions({.limits = {.max = 0.9, .rms = 0.005}}),
            positions({.limits = {.rms = 0.005}}));
  EXPECT_EQ(positions({.limits = {.max = 0.01, .rms = 0.9}}), positions({.limits = {.max = 0.01}}));
  EXPECT_EQ(positions({.limits = {.p99_stretch = 0.015, .p99_compression = 0.005}}),
            positions({.limits = {.max = 0.01}}))
      << "as much as both ask for";
}

TEST(Auto, IsSmootherWithoutRoomForRoughness) {
  const TriMesh mesh = make_shape("panel", 1500);
  const EvolveResult smooth = run(mesh, {.limits = {.max = 0.01}, .closeness = 0.0});
  const EvolveResult rough = run(mesh, {.limits = {.max = 0.01}, .closeness = 2.0});
  EXPECT_EQ(smooth.stop, StopReason::strain_met);
  EXPECT_EQ(rough.stop, StopReason::strain_met);
  EXPECT_LT(figures_of(mesh, smooth.positions).roughness,
            0.8 * figures_of(mesh, rough.positions).roughness);
}

TEST(Auto, MovesNothingWhereTheStrainIsWithinTheLimit) {
  const TriMesh mesh = make_shape("panel", 6500);
  const EvolveResult result = run(mesh, {.limits = {.max = 1.0}});
  EXPECT_EQ(result.stop, StopReason::strain_met);
  EXPECT_EQ(result.positions, mesh.positions);
}

TEST(Auto, KeepsTheDeviationWhereLimitsConflict) {
  const TriMesh mesh = make_shape("dome", 1500);
  constexpr double most = 10.0;  // millimetres
  const EvolveResult result = run(mesh, {.limits = {.max = 1e-3}, .max_deviation = most});
  EXPECT_EQ(result.stop, StopReason::deviation_limit);
  EXPECT_LE(measure_deviation(Patch(mesh), result.positions).max, most * (1.0 + 1e-12));
  EXPECT_LT(figures_of(mesh, result.positions).sum_abs_defect,
            0.9 * measure(Patch(mesh)).sum_abs_defect);
}

/// Some inner vertices, far apart.
Constraints some_fixed(const TriMesh& mesh, std::size_t step) {
  const Patch patch(mesh);
  const auto inner = patch.inner_vertices();
  Constraints constraints;
  for (std::size_t i = 0; i < inner.size(); i += step)
    constraints.fixed.push_back(inner[i]);
  return constraints;
}

TEST(Auto, FlattensAroundFixedVertices) {
  const TriMesh mesh = make_shape("panel", 600);
  const Constraints constraints = some_fixed(mesh, 200);
  const EvolveResult result = run(mesh, {}, constraints);
  for (const Index v : constraints.fixed)
    EXPECT_EQ(result.positions[v], mesh.positions[v]);
  EXPECT_LT(figures_of(mesh, result.positions).sum_abs_defect,
            0.1 * measure(Patch(mesh)).sum_abs_defect);
}

TEST(Auto, LeavesFixedVerticesOnAllLevels) {
  const TriMesh mesh = make_shape("panel", 6500);
  const Constraints constraints = some_fixed(mesh, 1500);
  Stopping stopping = usual_stopping(k_near);
  stopping.max_sweeps = 25;  // the end is far from here, and has a test of its own
  const EvolveResult result = evolve(Patch(mesh), k_near, stopping, constraints);
  EXPECT_LT(result.history.front().level->inner_vertices, 3000U);
  EXPECT_NE(result.positions, mesh.positions);
  for (const Index v : constraints.fixed)
    EXPECT_EQ(result.positions[v], mesh.positions[v]);
}

TEST(CoarseLevels, LiftSmoothMovesNearlyAsTheyAre) {
  const TriMesh mesh = make_shape("saddle", 30000);
  const Patch surface(mesh);
  ThreadPool pool(1);
  PatchState fine(surface, pool);
  const CoarseLevels levels(fine, 6000, {}, pool);
  ASSERT_EQ(levels.coarsest(), 2U);
  EXPECT_EQ(CoarseLevels(*levels.make_state(2, pool), 6000, {}, pool).coarsest(), 0U);
  const auto coarse = levels.make_state(1, pool);
  // A dent that is nothing at the border: one half wave across the middle of the patch.
  const double size = norm(mesh.positions.front() - mesh.positions.back());
  Vec3 middle;
  for (const Vec3 p : mesh.positions)
    middle += (1.0 / static_cast<double>(mesh.positions.size())) * p;
  const auto dent = [&](const PatchState& state, Index v) {
    const double r = norm((1.0 / state.scale()) * state.origin(v) - middle) / size;
    return (state.scale() * size) * Vec3{0.0, 0.0, 0.1 * std::exp(-60.0 * r * r)};
  };
  for (Index v = 0; v < coarse->inner_count(); ++v)
    coarse->move(v, coarse->origin(v) + dent(*coarse, v));
  const AngleJacobian jacobian = angle_jacobian_of(fine);
  levels.lift(1, *coarse, FairnessEnergy(jacobian, fine, 0.02), fine, pool);
  double worst = 0.0, most = 0.0;
  for (Index v = 0; v < fine.inner_count(); ++v) {
    worst = std::max(worst, norm(fine.position(v) - fine.origin(v) - dent(fine, v)));
    most = std::max(most, norm(dent(fine, v)));
  }
  EXPECT_LT(worst, 0.03 * most);
}

}  // namespace
}  // namespace planish
