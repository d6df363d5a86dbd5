// Runs on patches so large that they take seconds: not repeated under the sanitizers.

#include <planish/evolve/evolve.h>
#include <planish/flatten/flatten.h>
#include <planish/measure/deviation.h>
#include <planish/measure/fairness.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "support/evolved.h"

namespace planish {
namespace {

using auto_runs::k_no_strain, auto_runs::rms_strain, auto_runs::run;

FlattenReport run_flatten(const TriMesh& mesh, const FlattenOptions& options, unsigned threads) {
  Context context;
  context.threads = threads;
  return flatten(Patch(mesh), "patch", options, context);
}

TEST(SmoothAuto, StaysNearerTheMoreItMayBend) {
  const TriMesh mesh = make_shape("panel", 1600);
  const Patch patch(mesh);
  double before = 1e300;
  for (const double bound : {0.5, 1.0, 1.5}) {
    const EvolveResult result = run(mesh, {.max_bending = bound});
    EXPECT_EQ(result.stop, StopReason::strain_met) << bound;
    EXPECT_LE(rms_strain(mesh, result.positions), 1.1 * k_no_strain) << bound;
    const double bending = *measure_fairness(patch, result.positions).bending_ratio;
    EXPECT_LE(bending, bound);
    EXPECT_GE(bending, 0.9 * bound);
    const double away = measure_deviation(patch, result.positions).rms;
    EXPECT_LT(away, before) << bound;
    before = away;
  }
}

TEST(SmoothAuto, LeavesNoMoreStrainWithABoundOfBending) {
  const TriMesh mesh = make_shape("panel", 10'000);
  for (const double bound : {0.9, 1.3}) {
    const EvolveResult result = run(mesh, {.max_bending = bound}, 2);
    EXPECT_EQ(result.stop, StopReason::strain_met) << bound;
    EXPECT_LE(rms_strain(mesh, result.positions), 1.1 * k_no_strain) << bound;
    EXPECT_LE(*measure_fairness(Patch(mesh), result.positions).bending_ratio, bound);
  }
}

TEST(SmoothAuto, BecomesFlattenableAndNearWhereItMayBend) {
  const TriMesh mesh = make_shape("panel", 1600);
  const Patch patch(mesh);
  const auto away = [&](const EvolveResult& result) {
    return measure_deviation(patch, result.positions).rms;
  };
  const EvolveResult bent = run(mesh, {.max_bending = 3.0, .prefer = Prefer::flat});
  EXPECT_EQ(bent.stop, StopReason::converged);
  EXPECT_LE(measure(Patch({bent.positions, mesh.triangles})).e_max, k_flattenable_e_max);
  EXPECT_LE(*measure_fairness(patch, bent.positions).bending_ratio, 3.0);
  EXPECT_LT(away(bent), away(run(mesh, {.prefer = Prefer::flat})));
}

TEST(LeastChange, OfALargePatchIsThatOfASmallOne) {
  const auto changed = [](std::size_t vertices) {
    return run_flatten(make_shape("panel", vertices), {.limits = {.rms = 0.004}}, 0);
  };
  const FlattenReport large = changed(12'500), small = changed(3'000);
  EXPECT_TRUE(all_kept(large.unfold.limits));
  EXPECT_TRUE(large.evolve.fairness.is_smooth());
  EXPECT_GT(large.evolve.deviation.rms, 0.0);
  EXPECT_LT(large.evolve.deviation.rms, 1.1 * small.evolve.deviation.rms);
}

TEST(LeastChange, IsTheSameOnAnyNumberOfThreads) {
  const TriMesh mesh = make_shape("panel", 500);
  for (const FlattenOptions& options : {FlattenOptions{.limits = {.p99 = 0.008}},
                                        FlattenOptions{.as_needed = {.max_deviation = 2.0}}}) {
    const auto one = run_flatten(mesh, options, 1), three = run_flatten(mesh, options, 3);
    EXPECT_EQ(one.processed.positions(), three.processed.positions());
    EXPECT_EQ(one.unfold.pattern.positions, three.unfold.pattern.positions);
  }
}

}  // namespace
}  // namespace planish
