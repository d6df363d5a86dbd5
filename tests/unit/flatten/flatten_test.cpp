// The main job as a whole, where limits of strain lead it.

#include <limits>
#include <optional>

#include <planish/core/error.h>
#include <planish/flatten/flatten.h>
#include <planish/measure/deviation.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "measure/smoothed.h"
#include "support/meshes.h"
#include "support/watched_job.h"

namespace planish {
namespace {

FlattenReport flattened(const TriMesh& mesh, const FlattenOptions& options) {
  return flatten(Patch(mesh), "patch", options);
}

/// A part of the way from the design to the positions of a report.
std::vector<Vec3> part_of_the_way(const TriMesh& design, const FlattenReport& report,
                                  double share) {
  std::vector<Vec3> positions = design.positions;
  for (std::size_t v = 0; v < positions.size(); ++v)
    positions[v] += share * (report.processed.positions()[v] - positions[v]);
  return positions;
}

TEST(FlattenWithLimits, LeavesAPatchWhosePatternKeepsThemToTheBit) {
  const TriMesh mesh = make_shape("panel", 400);
  const FlattenReport report = flattened(mesh, {.limits = {.max = 0.05}});
  EXPECT_EQ(report.processed.positions(), mesh.positions);
  EXPECT_TRUE(report.evolve.result.history.empty());
  EXPECT_EQ(report.evolve.result.stop, StopReason::strain_met);
  EXPECT_EQ(report.evolve.deviation.max, 0.0);
  ASSERT_EQ(report.unfold.limits.size(), 1U);
  EXPECT_TRUE(report.unfold.limits[0].met);
  EXPECT_LE(report.unfold.strain.max, 0.05);
  EXPECT_GT(report.design_least_stretch.strain.max, 0.05) << "by least stretch it does not";
}

TEST(FlattenWithLimits, ChangesAPatchOnlyAsFarAsItsPatternNeeds) {
  const TriMesh mesh = make_shape("dome", 400);
  const Patch patch(mesh);
  const Auto by_estimate{.limits = {.max = 0.06}, .prefer = Prefer::near};
  const auto all_the_way = evolve(patch, by_estimate, usual_stopping(by_estimate));
  const double far = measure_deviation(patch, all_the_way.positions).rms;
  for (const StrainLimits& limits : {StrainLimits{.max = 0.06}, StrainLimits{.p99 = 0.06}}) {
    const FlattenReport report =
        flattened(mesh, {.method = Auto{.prefer = Prefer::near}, .limits = limits});
    EXPECT_TRUE(all_kept(report.unfold.limits));
    EXPECT_GT(report.evolve.deviation.rms, 0.0);
    EXPECT_LT(report.evolve.deviation.rms, 0.8 * far);
    EXPECT_EQ(report.evolve.deviation.rms,
              measure_deviation(patch, report.processed.positions()).rms);
    EXPECT_EQ(report.evolve.after.figures.e_max, measure(report.processed).e_max);
    // A little less far it would not do.
    TriMesh nearer = mesh;
    nearer.positions = part_of_the_way(mesh, report, 0.9);
    EXPECT_FALSE(all_kept(unfold_patch(Patch(nearer), Unit::mm, {.limits = limits}).limits));
  }
}

/// Whether a surface between the design and the result bends more than was allowed although its
/// pattern keeps the limits.
bool bends_too_much_on_the_way(const TriMesh& mesh, const FlattenReport& report, double max_bending,
                               const StrainLimits& limits) {
  for (double share = 0.975; share > 0.3; share -= 0.025) {
    const TriMesh between{part_of_the_way(mesh, report, share), mesh.triangles};
    if (!measure_fairness(Patch(mesh), between.positions).is_smooth_within(max_bending) &&
        all_kept(unfold_patch(Patch(between), Unit::mm, {.limits = limits}).limits))
      return true;
  }
  return false;
}

TEST(FlattenWithLimits, BendsAsWasAskedForWhereTheSurfaceHalfWayBendsMore) {
  const TriMesh mesh = make_shape("dome", 500);
  struct Case {
    double max_bending;  // 0: to be smooth
    StrainLimits limits;
  };
  for (const Case& asked : {Case{0.0, {.max = 0.01}}, Case{1.0, {.max = 0.005}}}) {
    const Auto method{.max_bending = asked.max_bending};
    const FlattenReport report = flattened(mesh, {.method = method, .limits = asked.limits});
    EXPECT_TRUE(all_kept(report.unfold.limits));
    EXPECT_TRUE(report.evolve.fairness.is_smooth_within(asked.max_bending));
    EXPECT_TRUE(bends_too_much_on_the_way(mesh, report, asked.max_bending, asked.limits))
        << "or there is nothing to be seen here";
  }
}

TEST(FlattenWithLimits, TakesABorderWithoutADistanceForOneThatStays) {
  const TriMesh mesh = make_shape("dome", 400);
  const auto positions_with = [&](BorderFreedom::Rule rule) {
    const Auto method{.prefer = Prefer::near, .border = {rule, 0.0}};
    return flattened(mesh, {.method = method, .limits = {.max = 0.06}}).processed.positions();
  };
  EXPECT_EQ(positions_with(BorderFreedom::Rule::within),
            positions_with(BorderFreedom::Rule::fixed));
}

TEST(FlattenWithLimits, TakesThoseOfTheMethodWhereThereAreNoOthers) {
  const TriMesh mesh = make_shape("panel", 400);
  const FlattenReport report = flattened(mesh, {.method = Auto{.limits = {.max = 0.05}}});
  ASSERT_EQ(report.unfold.limits.size(), 1U);
  EXPECT_EQ(report.unfold.limits[0].what, Criterion::strain);
  EXPECT_EQ(report.unfold.limits[0].limit, 0.05);
  EXPECT_TRUE(flattened(mesh, {.method = Auto{}}).unfold.limits.empty());
}

TEST(FlattenWithLimits, ComesToATargetThatIsAskedForBesides) {
  const TriMesh mesh = make_shape("panel", 400);
  Stopping stopping = usual_stopping(Auto{});
  stopping.target_e_max = 0.5 * measure(Patch(mesh)).e_max;
  const FlattenReport report = flattened(mesh, {.stopping = stopping, .limits = {.max = 0.5}});
  EXPECT_FALSE(report.evolve.result.history.empty());
}

TEST(Flatten, OfASmoothedDesignMeasuresTheDeviationFromTheRawOne) {
  const TriMesh raw = meshes::rough_grid(12, 10, 4);
  const FlattenReport report =
      flattened(raw, {.method = ControllableLaplacian{}, .smooth_first = 4.0});
  const Patch surface(raw);
  ASSERT_TRUE(report.evolve.smoothed_first);
  EXPECT_EQ(report.evolve.smoothed_first->length, 4.0);
  EXPECT_EQ(report.input.positions(), smoothed_positions(surface, 4.0));
  EXPECT_EQ(report.evolve.smoothed_first->moved.rms,
            measure_deviation(surface, report.input.positions()).rms);
  EXPECT_EQ(report.evolve.deviation.rms,
            measure_deviation(surface, report.processed.positions()).rms);
  EXPECT_EQ(report.evolve.before.figures.e_max, measure(report.input).e_max);
  EXPECT_EQ(report.evolve.fairness.bending_ratio,
            measure_fairness(report.input, report.processed.positions()).bending_ratio);
  const FlattenReport plain = flattened(raw, {.method = ControllableLaplacian{}});
  EXPECT_FALSE(plain.evolve.smoothed_first);
  EXPECT_THROW(flatten(surface, "patch", {.smooth_first = 4.0, .remesh = true}), Error);
  EXPECT_THROW(flatten(surface, "patch", {.constraints = {.fixed = {30}}, .smooth_first = 4.0}),
               Error);
  EXPECT_LT(report.evolve.before.figures.e_avg, 0.5 * plain.evolve.before.figures.e_avg);
}

TEST(FlattenWithLimits, ReportRisingProgressAndCanBeCancelledAnywhere) {
  const Patch patch(make_shape("dome", 200));
  const FlattenOptions options{.limits = {.max = 0.06}};
  WatchedJob job;
  flatten(patch, "patch", options, job.context());
  EXPECT_GT(job.reports(), 20);
  EXPECT_EQ(job.share(), 1.0);
  expect_cancellable([&](const Context& context) { flatten(patch, "patch", options, context); });
}

TEST(Flatten, CanBeCancelledWhileBothPatternsAreMade) {
  const Patch patch(make_shape("dome", 200));
  const FlattenOptions options{.method = ControllableLaplacian{}};
  for (const unsigned threads : {1U, 2U}) {
    expect_cancellable([&](Context context) {
      context.threads = threads;
      flatten(patch, "patch", options, context);
    });
  }
}

/// The code of the error, if there is one.
std::optional<ErrorCode> refusal_of(const FlattenOptions& options) {
  try {
    flattened(make_shape("panel", 150), options);
  } catch (const Error& error) {
    return error.code();
  }
  return std::nullopt;
}

TEST(FlattenOptions, OutOfTheirRangeAreRefused) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto expect_refused = [](FlattenOptions options, const char* what) {
    for (const bool keep_design : {false, true}) {
      options.keep_design = keep_design;
      EXPECT_EQ(refusal_of(options), ErrorCode::option_out_of_range) << what << keep_design;
    }
  };
  for (const double wrong : {none, -0.02, infinity, 2.0}) {
    expect_refused({.limits = {.max = wrong}}, "max");
    expect_refused({.limits = {.p99 = wrong}}, "p99");
    expect_refused({.limits = {.rms = wrong}}, "rms");
    expect_refused({.method = Auto{.limits = {.max = wrong}}}, "of the method");
    expect_refused({.method = Auto{.limits = {.p99_stretch = wrong}}}, "of one side");
    expect_refused({.method = Auto{.limits = {.rms = wrong}}, .limits = {.max = 0.1}}, "unused");
  }
  for (const double wrong : {none, -1.0}) {
    expect_refused({.smooth_first = wrong}, "smooth_first");
    expect_refused({.stopping = Stopping{.target_e_max = wrong}}, "target_e_max");
  }
  EXPECT_FALSE(refusal_of({.keep_design = true, .limits = {.max = 1.0}})) << "the largest";
}

// The image of an obstacle in the plane of the fold is not known to the method.
TEST(FlattenOptions, OfAFoldAndAnObstacleAreRefused) {
  FlattenOptions options;
  options.fold = {0, 1};
  options.constraints.obstacle = meshes::flat_grid(2, 2);
  EXPECT_EQ(refusal_of(options), ErrorCode::unsupported_constraint);
}

}  // namespace
}  // namespace planish
