#include <algorithm>

#include <planish/evolve/evolve.h>
#include <planish/measure/deviation.h>
#include <planish/measure/fairness.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "support/evolved.h"

namespace planish {
namespace {

using namespace auto_runs;

TEST(SmoothAuto, LeavesNoMeasurableStrainAndNoCrumples) {
  for (const std::size_t size : {300, 800}) {
    const TriMesh mesh = make_shape("panel", size);
    const EvolveResult result = run(mesh, smooth());
    EXPECT_EQ(result.stop, StopReason::strain_met) << size;
    EXPECT_LE(rms_strain(mesh, result.positions), 1.1 * k_no_strain) << size;
    EXPECT_TRUE(measure_fairness(Patch(mesh), result.positions).bends_little()) << size;
    EXPECT_EQ(farthest(mesh, result.positions, true), 0.0) << size;
  }
}

TEST(SmoothAuto, GoesFromCoarseToFine) {
  const TriMesh mesh = make_shape("panel", 6000);
  const EvolveResult result = run(mesh, smooth(), 2);
  EXPECT_LE(rms_strain(mesh, result.positions), 1.1 * k_no_strain);
  EXPECT_TRUE(measure_fairness(Patch(mesh), result.positions).bends_little());
  EXPECT_LT(result.history.front().level->inner_vertices,
            result.history.back().level->inner_vertices);
  EXPECT_EQ(run(mesh, smooth(), 1).positions, result.positions);
}

TEST(SmoothAuto, KeepsWhatCoarseLevelsFoundAtTheLimitOfSweeps) {
  const TriMesh mesh = make_shape("panel", 6000);
  const EvolveResult result = evolve(Patch(mesh), smooth(), {.max_sweeps = 6}, {}, {.threads = 1});
  EXPECT_EQ(result.stop, StopReason::sweep_limit);
  EXPECT_LT(rms_strain(mesh, result.positions), 0.8 * rms_strain(mesh, mesh.positions));
}

TEST(SmoothAuto, StaysNearerTheMoreStrainMayStay) {
  const TriMesh mesh = make_shape("panel", 800);
  const Patch patch(mesh);
  double before = 1e300;
  for (const double limit : {0.001, 0.002, 0.004}) {
    Auto method = smooth();
    method.limits.rms = limit;
    const EvolveResult result = run(mesh, method);
    EXPECT_LE(rms_strain(mesh, result.positions), 1.1 * limit) << limit;
    const double away = measure_deviation(patch, result.positions).rms;
    EXPECT_LT(away, before) << limit;
    before = away;
  }
}

TEST(SmoothAuto, StaysSmoothWhereTheBorderForbidsFlatness) {
  const TriMesh dome = make_shape("dome", 500);
  const EvolveResult result = run(dome, smooth());
  EXPECT_NE(result.stop, StopReason::strain_met);
  EXPECT_TRUE(measure_fairness(Patch(dome), result.positions).bends_little());
  EXPECT_LE(rms_strain(dome, result.positions), rms_strain(dome, dome.positions) + 1e-12);
}

TEST(SmoothAuto, BecomesFlattenableWhereThatIsPreferred) {
  const TriMesh mesh = make_shape("panel", 800);
  const Patch patch(mesh);
  const EvolveResult result = run(mesh, {.prefer = Prefer::flat});
  EXPECT_EQ(result.stop, StopReason::converged);
  const TriMesh after{result.positions, mesh.triangles};
  EXPECT_LE(measure(Patch(after)).e_max, k_flattenable_e_max);
  EXPECT_LE(*measure_fairness(patch, result.positions).bending_ratio, 1.6);
}

TEST(SmoothAuto, KeepsABoundOfBendingBesideOtherLimits) {
  const TriMesh mesh = make_shape("panel", 800);
  const Patch patch(mesh);
  for (const Auto& method : {Auto{.limits = {.rms = 0.002}, .max_bending = 1.2},
                             Auto{.max_deviation = 20.0, .max_bending = 1.2},
                             Auto{.max_bending = 1.2, .border = {BorderFreedom::Rule::slide}}}) {
    const EvolveResult result = run(mesh, method);
    EXPECT_EQ(result.stop, StopReason::strain_met);
    EXPECT_LE(*measure_fairness(patch, result.positions).bending_ratio, 1.2);
    EXPECT_LE(farthest(mesh, result.positions, false), method.max_deviation * (1.0 + 1e-12));
  }
}

TEST(SmoothAuto, KeepsTheBoundOfBendingWhereTheBorderForbidsFlatness) {
  const TriMesh dome = make_shape("dome", 500);
  for (const double bound : {0.1, 1.0, 2.0, 1e6}) {
    const EvolveResult result = run(dome, {.max_bending = bound});
    EXPECT_NE(result.stop, StopReason::sweep_limit) << bound;
    const Fairness fairness = measure_fairness(Patch(dome), result.positions);
    EXPECT_LE(*fairness.bending_ratio, std::max(bound, fairness.design_ratio)) << bound;
    EXPECT_LE(rms_strain(dome, result.positions), rms_strain(dome, dome.positions) + 1e-12);
  }
}

TEST(SmoothAuto, KeepsTheLimitOfDeviation) {
  const TriMesh mesh = make_shape("panel", 800);
  const double free = farthest(mesh, run(mesh, smooth()).positions, false);
  Auto method = smooth();
  method.max_deviation = 0.5 * free;
  const EvolveResult result = run(mesh, method);
  EXPECT_LE(farthest(mesh, result.positions, false), method.max_deviation * (1.0 + 1e-12));
  EXPECT_GT(farthest(mesh, result.positions, false), 0.5 * method.max_deviation);
}

TEST(SmoothAuto, MovesTheBorderWithinItsDistance) {
  const TriMesh mesh = make_shape("panel", 800);
  const Patch patch(mesh);
  const double held = measure_deviation(patch, run(mesh, smooth()).positions).rms;
  Auto method = smooth();
  method.border = {BorderFreedom::Rule::within,
                   0.02 * norm(mesh.positions.front() - mesh.positions.back())};
  const EvolveResult result = run(mesh, method);
  EXPECT_EQ(result.stop, StopReason::strain_met);
  const double far = farthest(mesh, result.positions, true);
  EXPECT_GT(far, 0.0);
  EXPECT_LE(far, method.border.distance * (1.0 + 1e-12));
  EXPECT_LT(measure_deviation(patch, result.positions).rms, held);
}

TEST(SmoothAuto, MovesTheDearLess) {
  const TriMesh mesh = make_shape("panel", 400);
  const auto plain = run(mesh, smooth()).positions;
  Index farthest_vertex = 0;
  const auto away = [&](const std::vector<Vec3>& positions, Index v) {
    return norm(positions[v] - mesh.positions[v]);
  };
  for (Index v = 0; v < plain.size(); ++v) {
    if (away(plain, v) > away(plain, farthest_vertex)) farthest_vertex = v;
  }
  Constraints constraints;
  constraints.weights.assign(mesh.positions.size(), 1.0);
  constraints.weights[farthest_vertex] = 1e4;
  const auto dear =
      evolve(Patch(mesh), smooth(), usual_stopping(smooth()), constraints, {.threads = 1})
          .positions;
  EXPECT_LT(away(dear, farthest_vertex), 0.5 * away(plain, farthest_vertex));
}

TEST(SmoothAuto, LeavesFixedVertices) {
  const TriMesh mesh = make_shape("panel", 400);
  const Patch patch(mesh);
  Constraints constraints;
  for (Index v = 0; v < mesh.positions.size(); v += 40) {
    if (!patch.is_border(v)) constraints.fixed.push_back(v);
  }
  ASSERT_FALSE(constraints.fixed.empty());
  const auto after =
      evolve(patch, smooth(), usual_stopping(smooth()), constraints, {.threads = 1}).positions;
  for (const Index v : constraints.fixed)
    EXPECT_EQ(after[v], mesh.positions[v]);
  EXPECT_NE(after, mesh.positions);
}

TEST(SmoothAuto, LeavesAPlaneAndASmallPatchAlone) {
  TriMesh plane = make_shape("panel", 100);
  for (Vec3& p : plane.positions)
    p.z = 0.0;
  EXPECT_EQ(run(plane, smooth()).positions, plane.positions);
  const TriMesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  EXPECT_EQ(run(one, smooth()).positions, one.positions);
}

TEST(SmoothAuto, WorksOnFewInnerVertices) {
  // A square pyramid of two rings.
  TriMesh cap;
  for (const double radius : {2.0, 1.0}) {
    for (int k = 0; k < 6; ++k) {
      const double x[] = {1, 0.5, -0.5, -1, -0.5, 0.5};
      const double y[] = {0, 0.866, 0.866, 0, -0.866, -0.866};
      cap.positions.push_back({radius * x[k], radius * y[k], 0.3 * (2.0 - radius)});
    }
  }
  cap.positions.push_back({0, 0, 0.4});
  for (Index k = 0; k < 6; ++k) {
    const Index next = (k + 1) % 6;
    cap.triangles.push_back({k, next, 6 + k});
    cap.triangles.push_back({next, 6 + next, 6 + k});
    cap.triangles.push_back({6 + k, 6 + next, 12});
  }
  const EvolveResult result = run(cap, smooth());
  EXPECT_TRUE(measure_fairness(Patch(cap), result.positions).bends_little());
  EXPECT_LE(rms_strain(cap, result.positions), rms_strain(cap, cap.positions) + 1e-12);
}

}  // namespace
}  // namespace planish
