// The default of flatten, which changes nothing, and what it says of the ways to less stretch.

#include <algorithm>

#include <planish/flatten/flatten.h>
#include <planish/measure/material.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

namespace planish {
namespace {

Patch panel() {
  return Patch(make_shape("panel", 600));
}

/// With a few per cent of stretch.
Patch low_dome() {
  TriMesh dome = make_shape("dome", 600);
  for (Vec3& p : dome.positions)
    p.z *= 0.7;
  return Patch(std::move(dome));
}

FlattenReport flattened(const FlattenOptions& options) {
  return flatten(panel(), "panel", options);
}

TEST(FlattenDefault, KeepsTheDesignToTheBitAndSpreadsItsStretch) {
  const FlattenReport report = flattened({});
  EXPECT_EQ(report.processed.positions(), panel().positions());
  EXPECT_FALSE(report.evolve.method);
  EXPECT_EQ(report.evolve.method_name(), "none");
  EXPECT_EQ(report.evolve.auto_options(), nullptr);
  EXPECT_TRUE(report.evolve.result.history.empty());
  EXPECT_TRUE(report.evolve.fairness.unchanged);
  EXPECT_EQ(report.unfold.pattern.positions, unfold(panel()).positions);
  EXPECT_LT(report.unfold.strain.p99, report.unfold.unlimited_strain->p99);
  EXPECT_TRUE(report.outcome().usable());
  EXPECT_EQ(report.candidates().size(), 1U);
}

TEST(FlattenDefault, HasThePatternOfLeastStretchOnRequest) {
  const FlattenReport report = flattened({.least_stretch = true});
  EXPECT_EQ(report.unfold.pattern.positions, unfold(panel(), {.least_stretch = true}).positions);
}

TEST(FlattenDefault, EvolvesByAMethodOrWhereALimitIsMissed) {
  EXPECT_FALSE(FlattenOptions{}.may_change());
  EXPECT_TRUE((FlattenOptions{.method = ControllableLaplacian{}}.may_change()));
  EXPECT_TRUE((FlattenOptions{.limits = {.rms = 0.01}}.may_change()));
  EXPECT_TRUE((FlattenOptions{.as_needed = {.limits = {.rms = 0.01}}}.may_change()));
  const double rms = flattened({}).unfold.strain.rms;
  EXPECT_TRUE(flattened({.limits = {.rms = 1.1 * rms}}).evolve.fairness.unchanged);
  const FlattenReport changed = flattened({.limits = {.rms = 0.5 * rms}});
  EXPECT_FALSE(changed.evolve.fairness.unchanged);
  EXPECT_EQ(changed.evolve.method_name(), "auto");
}

TEST(FlattenDefault, SpreadsTheStretchWithinALimitThatTheDesignKeeps) {
  const FlattenReport plain = flattened({});
  const double loose = 1.5 * plain.unfold.unlimited_strain->p99;
  EXPECT_EQ(flattened({.limits = {.p99 = loose}}).unfold.pattern.positions,
            plain.unfold.pattern.positions);
}

std::vector<Way> ways_of(FlattenOptions options) {
  options.ways = true;
  return flattened(options).ways;
}

TEST(Ways, AreNoneWhereNothingMayMove) {
  EXPECT_TRUE(ways_of({.as_needed = {.max_deviation = 0.0}, .limits = {.rms = 0.001}}).empty());
}

TEST(Ways, AreOfLimitsThatTheDesignMisses) {
  const EdgeStrain design = flattened({}).unfold.strain;
  const std::vector<Way> ways = ways_of({});
  ASSERT_FALSE(ways.empty());
  EXPECT_LE(ways.size(), 6U);
  for (const Way& way : ways) {
    EXPECT_TRUE(way.estimated);
    EXPECT_EQ(way.material.empty(), way.limits.rms > 0.0);
    EXPECT_LT(way.limits.rms + way.limits.p99, way.material.empty() ? design.rms : design.p99);
  }
}

TEST(Ways, MoveTheMoreTheLessStretchIsLeft) {
  std::vector<Way> ways = flatten(low_dome(), "dome", {.ways = true}).ways;
  std::erase_if(ways, [](const Way& way) { return !way.material.empty() || !way.reached; });
  ASSERT_GE(ways.size(), 2U);
  for (std::size_t k = 1; k < ways.size(); ++k) {
    EXPECT_LT(ways[k].limits.rms, ways[k - 1].limits.rms);
    EXPECT_GT(ways[k].deviation.rms, ways[k - 1].deviation.rms);
  }
}

TEST(Ways, HaveTheFiguresOfTheRunWhereItIsOneOfThem) {
  const FlattenReport report = flattened({.limits = {.rms = 0.005}, .ways = true});
  const auto exact = std::find_if(report.ways.begin(), report.ways.end(),
                                  [](const Way& way) { return !way.estimated; });
  ASSERT_NE(exact, report.ways.end());
  EXPECT_EQ(exact->limits.rms, 0.005);
  EXPECT_EQ(exact->deviation.max, report.evolve.deviation.max);
  EXPECT_EQ(exact->strain.rms, report.unfold.strain.rms);
  EXPECT_EQ(std::count_if(report.ways.begin(), report.ways.end(),
                          [](const Way& way) { return way.limits.rms == 0.005; }),
            1);
  const std::vector<Way> other = ways_of({.limits = {.rms = 0.004}});
  EXPECT_EQ(other.front().limits.rms, 0.004) << "a limit of the run's own comes first";
  EXPECT_FALSE(other.front().estimated);
}

TEST(Ways, EstimateWhatTheRunThenDoes) {
  const Patch dome = low_dome();
  const std::vector<Way> estimates = flatten(dome, "dome", {.ways = true}).ways;
  const auto estimate = std::find_if(estimates.begin(), estimates.end(),
                                     [](const Way& way) { return way.limits.rms == 0.02; });
  ASSERT_NE(estimate, estimates.end());
  const Deviation run = flatten(dome, "dome", {.limits = {.rms = 0.02}}).evolve.deviation;
  EXPECT_NEAR(estimate->deviation.rms, run.rms, 0.2 * run.rms);
  EXPECT_NEAR(estimate->deviation.max, run.max, 0.2 * run.max);
}

TEST(Ways, TellOfTheSmallMoveOfALimitThatIsNear) {
  const std::vector<Way> estimates = ways_of({});
  const auto estimate = std::find_if(estimates.begin(), estimates.end(),
                                     [](const Way& way) { return way.material == "leather"; });
  ASSERT_NE(estimate, estimates.end());
  const Deviation run =
      flattened({.limits = limits_of(material_named("leather"))}).evolve.deviation;
  ASSERT_GT(run.max, 0.0);
  EXPECT_NEAR(estimate->deviation.max, run.max, 0.3 * run.max);
}

TEST(Ways, AreLeftOutWhereThereIsNothingToSay) {
  EXPECT_TRUE(flattened({}).ways.empty()) << "they were not asked for";
  EXPECT_TRUE(ways_of({.method = Auto{}}).empty()) << "another way was chosen";
  EXPECT_TRUE(ways_of({.constraints = {.fixed = {0}}}).empty())
      << "a coarse mesh has no such vertex";
  const Patch cone(make_shape("cone", 300));
  EXPECT_TRUE(flatten(cone, "cone", {.ways = true}).ways.empty()) << "it lies flat";
}

TEST(Ways, AreTheSameBitsForEveryNumberOfThreads) {
  const auto one = flatten(panel(), "panel", {.ways = true}, {.threads = 1}).ways;
  const auto three = flatten(panel(), "panel", {.ways = true}, {.threads = 3}).ways;
  ASSERT_EQ(one.size(), three.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].deviation.rms, three[k].deviation.rms);
    EXPECT_EQ(one[k].strain.p99, three[k].strain.p99);
  }
}

TEST(Ways, KeepTheEndsOfAFold) {
  // The border lies in no plane, so the fold itself is idle.
  const Patch patch = panel();
  const auto& loop = patch.border_loops().front();
  const std::array<Index, 2> ends = {loop[0], loop[loop.size() / 4]};
  EXPECT_FALSE(flatten(patch, "half", {.fold = ends, .ways = true}).ways.empty());
}

}  // namespace
}  // namespace planish
