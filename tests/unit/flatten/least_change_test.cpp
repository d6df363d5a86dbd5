// The least change that limits need, and the least strain within a tolerance.

#include "flatten/steps/least_change.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "core/math.h"
#include "measure/smoothed_border.h"
#include "support/meshes.h"

namespace planish {
namespace {

/// The trials that a search makes where the excess is this function of the amount.
template <class Excess>
std::vector<double> trials(BoundarySearch search, const Excess& excess) {
  std::vector<double> amounts;
  while (const auto amount = search.next()) {
    amounts.push_back(*amount);
    search.tell(*amount, excess(*amount));
  }
  return amounts;
}

TEST(BoundarySearch, FindsWhereAStraightLineCrossesWithTwoTrials) {
  const auto rising = trials({0.0, 0.001, 1.0, 4}, [](double x) { return 100.0 * x; });
  ASSERT_GE(rising.size(), 2U);
  EXPECT_LE(rising.back(), 0.01) << "the last one holds";
  EXPECT_GT(rising.back(), 0.009);
  const auto falling = trials({3.0, 0.05, 1.0, 4}, [](double x) { return 3.0 - 100.0 * x; });
  ASSERT_GE(falling.size(), 1U);
  EXPECT_GE(falling.back(), 0.02) << "the last one holds";
  EXPECT_LT(falling.back(), 0.05);
}

TEST(BoundarySearch, StaysWithinItsRangeAndEnds) {
  EXPECT_EQ(trials({0.0, 0.4, 1.0, 4}, [](double) { return 0.5; }).back(), 1.0)
      << "all of it holds";
  EXPECT_EQ(trials({2.0, 5.0, 1.0, 3}, [](double) { return 2.0; }), std::vector<double>{1.0})
      << "nothing does";
  const auto jump = trials({0.0, 0.4, 1.0, 9}, [](double x) { return 2.0 + 0.1 * x; });
  EXPECT_EQ(jump.size(), 2U) << "none holds, however small";
}

FlattenReport run_flatten(const TriMesh& mesh, const FlattenOptions& options) {
  Context context;
  context.threads = 1;
  return flatten(Patch(mesh), "patch", options, context);
}

TEST(LeastChange, IsNearerThanTheSurfaceThatKeepsTheLimitByItsEstimate) {
  const TriMesh mesh = make_shape("panel", 700);
  const Patch patch(mesh);
  for (const StrainLimits& limits : {StrainLimits{.max = 0.008}, StrainLimits{.p99 = 0.008}}) {
    const FlattenReport report = run_flatten(mesh, {.limits = limits});
    const Auto by_estimate{.limits = {.max = 0.008}};
    const EvolveResult direct = evolve(patch, by_estimate, usual_stopping(by_estimate));
    EXPECT_TRUE(all_kept(report.unfold.limits));
    EXPECT_TRUE(report.evolve.fairness.is_smooth());
    EXPECT_EQ(report.evolve.result.stop, StopReason::strain_met);
    EXPECT_GT(report.evolve.deviation.rms, 0.0) << "or there is nothing to be seen here";
    EXPECT_LT(report.evolve.deviation.rms, 0.8 * measure_deviation(patch, direct.positions).rms);
    // What is written is what was measured.
    const auto again = unfold_patch(report.processed, Unit::mm, {.limits = limits});
    EXPECT_TRUE(all_kept(again.limits));
    EXPECT_EQ(report.evolve.deviation.rms,
              measure_deviation(patch, report.processed.positions()).rms);
  }
}

void expect_within(const FlattenReport& report, double distance) {
  EXPECT_LE(report.evolve.deviation.max, distance * (1.0 + 1e-9));
  const Fairness& fairness = report.evolve.fairness;
  EXPECT_LE(fairness.sharpest_fold ? fairness.sharpest_fold->degrees : 0.0,
            Tolerance::most_new_fold);
  EXPECT_LE(fairness.bending_added.value_or(0.0), Tolerance::most_added);
}

TEST(Tolerance, LeavesTheLessStrainTheLargerItIs) {
  for (const char* shape : {"panel", "saddle"}) {
    const TriMesh mesh = make_shape(shape, 700);
    const double diagonal = bounding_box_diagonal(mesh);
    double strain =
        run_flatten(mesh, {.keep_design = true, .least_stretch = true}).unfold.strain.rms;
    for (const double share : {0.002, 0.01}) {
      const FlattenReport report =
          run_flatten(mesh, {.as_needed = {.max_deviation = share * diagonal}});
      expect_within(report, share * diagonal);
      EXPECT_LT(least_strain(report.unfold).rms, strain) << shape << share;
      strain = least_strain(report.unfold).rms;
      const std::vector<Criterion> missed = report.outcome().missed;
      EXPECT_EQ(std::count(missed.begin(), missed.end(), Criterion::stretched), 0)
          << "what is left is no fault";
    }
  }
}

// Of a saddle with hardly less strain, spreading within the usual budget would need a sheet that
// takes more.
TEST(Tolerance, NeedsNoSheetThatTakesMoreThanOfTheDesign) {
  for (const char* shape : {"panel", "saddle"}) {
    const TriMesh mesh = make_shape(shape, 700);
    const FlattenReport report =
        run_flatten(mesh, {.as_needed = {.max_deviation = 0.002 * bounding_box_diagonal(mesh)}});
    EXPECT_GT(report.evolve.deviation.max, 0.0);
    EXPECT_LE(report.unfold.strain.p99, report.design_pattern.strain.p99) << shape;
    ASSERT_TRUE(report.unfold.unlimited_strain) << shape;
    EXPECT_LT(report.unfold.unlimited_strain->rms, report.design_pattern.unlimited_strain->rms);
    EXPECT_LT(report.unfold.strain.p99, report.unfold.unlimited_strain->p99) << shape;
    EXPECT_TRUE(report.unfold.limits.empty()) << "none was given";
  }
}

TEST(Tolerance, OfNothingKeepsEveryBitAndJudgesThePattern) {
  const TriMesh mesh = make_shape("panel", 400);
  for (const StrainLimits& limits : {StrainLimits{}, StrainLimits{.p99 = 0.001}}) {
    const FlattenReport report =
        run_flatten(mesh, {.as_needed = {.max_deviation = 0.0}, .limits = limits});
    EXPECT_EQ(report.processed.positions(), mesh.positions);
    EXPECT_TRUE(report.evolve.result.history.empty());
    EXPECT_EQ(report.evolve.result.stop, StopReason::design_kept);
    EXPECT_EQ(all_kept(report.unfold.limits), !limits.any());
  }
}

TEST(Tolerance, WithALimitChangesNoMoreThanThatNeeds) {
  const TriMesh mesh = make_shape("panel", 500);
  const StrainLimits limits{.rms = 0.005};
  const double diagonal = bounding_box_diagonal(mesh), far = 0.05 * diagonal;
  const FlattenReport kept =
      run_flatten(mesh, {.as_needed = {.max_deviation = far}, .limits = limits});
  EXPECT_TRUE(all_kept(kept.unfold.limits));
  expect_within(kept, far);
  EXPECT_GT(kept.unfold.strain.rms, 0.8 * limits.rms) << "it stops there";
  const double near = 0.1 * kept.evolve.deviation.max;
  const FlattenReport missed =
      run_flatten(mesh, {.as_needed = {.max_deviation = near}, .limits = limits});
  EXPECT_FALSE(all_kept(missed.unfold.limits));
  expect_within(missed, near);
  EXPECT_LT(missed.unfold.strain.rms, missed.design_least_stretch.strain.rms);
  EXPECT_FALSE(missed.outcome().limits_met());
}

constexpr double k_radius = 100.0, k_height = 60.0, k_angle = std::numbers::pi / 3.0;

/// A sector of a tube as a scanner sees it.
TriMesh noisy_tube(double noise) {
  constexpr std::size_t columns = 52, rows = 30;
  TriMesh mesh = meshes::rough_grid(columns, rows, 7, 0.0, noise);
  double widest = 0.0, highest = 0.0;
  for (const Vec3& p : mesh.positions) {
    widest = std::max(widest, p.x);
    highest = std::max(highest, p.y);
  }
  for (Vec3& p : mesh.positions) {
    const double angle = k_angle * p.x / widest, r = k_radius + p.z;
    p = {r * math::sin(angle), k_height * p.y / highest, r * math::cos(angle)};
  }
  return mesh;
}

TEST(Tolerance, TakesNoiseOutFirst) {
  const TriMesh mesh = noisy_tube(0.4);
  const double area = k_radius * k_angle * k_height;
  EXPECT_GT(measure_size(Patch(mesh)).area, 1.02 * area);
  const FlattenReport report = run_flatten(
      mesh, {.as_needed = {.max_deviation = 1.0, .border = {BorderFreedom::Rule::within, 1.0}}});
  ASSERT_TRUE(report.evolve.smoothed_first);
  EXPECT_LE(report.evolve.deviation.max, 1.0 + 1e-9);
  EXPECT_NEAR(measure_size(report.processed).area, area, 0.005 * area);
  EXPECT_LT(report.unfold.strain.rms, 0.002);
}

TEST(SmoothedBorder, KeepsCornersAndEvensOutWhatIsBetween) {
  const TriMesh mesh = noisy_tube(0.4);
  const Patch patch(mesh);
  const auto smooth = with_smoothed_border(patch, 20.0);
  int held = 0;
  double before = 0.0, after = 0.0;
  const auto beside = [](Vec3 p) {
    const double d = std::sqrt(p.x * p.x + p.z * p.z) - k_radius;
    return d * d;
  };
  for (Index v = 0; v < smooth.size(); ++v) {
    if (!patch.is_border(v)) {
      EXPECT_EQ(smooth[v], mesh.positions[v]);
      continue;
    }
    held += smooth[v] == mesh.positions[v] ? 1 : 0;
    before += beside(mesh.positions[v]);
    after += beside(smooth[v]);
  }
  EXPECT_EQ(held, 4);
  EXPECT_LT(after, 0.3 * before);
}

}  // namespace
}  // namespace planish
