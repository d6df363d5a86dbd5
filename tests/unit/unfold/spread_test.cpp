// Spreading the stretch: what is promised of it, and its steps against finite differences.

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include <planish/mesh/shapes.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

#include <gtest/gtest.h>

#include "support/farthest.h"
#include "support/meshes.h"
#include "support/watched_job.h"

namespace planish {
namespace {

Pattern least_stretch(const Patch& patch) {
  return unfold(patch, {.least_stretch = true});
}

TEST(Spread, LowersThePeaksWithinItsBudget) {
  for (const char* shape : {"panel", "saddle", "dome"}) {
    const Patch patch(make_shape(shape, 600));
    const EdgeStrain least = edge_strain(patch, least_stretch(patch).positions);
    const Pattern pattern = unfold(patch);
    const EdgeStrain spread = edge_strain(patch, pattern.positions);
    EXPECT_LT(spread.p99, 0.9 * least.p99) << shape;
    EXPECT_LT(spread.max, 0.9 * least.max) << shape;
    EXPECT_LE(spread.rms, k_spread_budget * least.rms) << shape;
    EXPECT_EQ(pattern.flipped_triangles, 0U) << shape;
    EXPECT_FALSE(pattern.overlaps) << shape;
  }
}

TEST(Spread, UsesItsBudget) {
  const Patch patch(make_shape("panel", 600));
  const EdgeStrain least = edge_strain(patch, least_stretch(patch).positions);
  const EdgeStrain spread = edge_strain(patch, unfold(patch).positions);
  EXPECT_GT(spread.rms, 0.99 * k_spread_budget * least.rms);
}

TEST(Spread, KeepsALimitOfRmsThatLeastStretchKeeps) {
  const Patch patch(make_shape("panel", 600));
  const double least = edge_strain(patch, least_stretch(patch).positions).rms;
  const double limit = 1.02 * least;
  const EdgeStrain kept = edge_strain(patch, unfold(patch, {.limits = {.rms = limit}}).positions);
  EXPECT_LE(kept.rms, limit);
  EXPECT_GT(kept.rms, 1.01 * least) << "it spreads as far as the limit lets it";
}

TEST(LimitOfRms, IsKeptWhereLeastStretchMissesItByLittle) {
  for (const char* shape : {"panel", "saddle", "dome"}) {
    const Patch patch(make_shape(shape, 600));
    const Pattern least = least_stretch(patch);
    const double limit = 0.97 * edge_strain(patch, least.positions).rms;
    for (const bool least_stretch : {true, false}) {
      const Pattern pattern =
          unfold(patch, {.least_stretch = least_stretch, .limits = {.rms = limit}});
      EXPECT_LE(edge_strain(patch, pattern.positions).rms, limit) << shape;
      EXPECT_GT(edge_strain(patch, pattern.positions).rms, 0.95 * limit) << "no further";
      EXPECT_NEAR(edge_strain(patch, pattern.least_stretch).rms, limit / 0.97, 1e-9) << shape;
      EXPECT_EQ(pattern.flipped_triangles, 0U) << shape;
      EXPECT_FALSE(pattern.overlaps) << shape;
    }
  }
}

TEST(LimitOfRms, ThatNoPatternKeepsLeavesTheLeastThereIs) {
  const Patch patch(make_shape("panel", 600));
  const auto rms_of = [&](const std::vector<Vec2>& flat) { return edge_strain(patch, flat).rms; };
  const Pattern pattern = unfold(patch, {.least_stretch = true, .limits = {.rms = 1e-4}});
  const double least = rms_of(pattern.positions);
  EXPECT_LT(least, 0.97 * rms_of(pattern.least_stretch));
  // On the straight line through it and the pattern of least stretch it has the least rms.
  const auto from = centred(pattern.least_stretch), to = centred(pattern.positions);
  std::complex<double> turn;
  for (std::size_t v = 0; v < to.size(); ++v)
    turn += to[v] * std::conj(from[v]);
  turn /= std::abs(turn);
  for (const double share : {0.0, 0.5, 0.9, 1.1, 1.5}) {
    std::vector<Vec2> between;
    for (std::size_t v = 0; v < to.size(); ++v) {
      const std::complex<double> start = turn * from[v], p = start + share * (to[v] - start);
      between.push_back({p.real(), p.imag()});
    }
    EXPECT_GT(rms_of(between), 0.9999 * least) << share;
  }
}

TEST(LimitOfRms, HoldsMatchedSeams) {
  const Patch patch(make_shape("panel", 600));
  const Pattern least = unfold(patch, {.match_seams = true, .least_stretch = true});
  const double limit = 0.99 * edge_strain(patch, least.positions).rms;
  const Pattern pattern =
      unfold(patch, {.match_seams = true, .least_stretch = true, .limits = {.rms = limit}});
  EXPECT_LE(edge_strain(patch, pattern.positions).rms, limit);
  EXPECT_LT(largest_border_strain(patch, pattern.positions), 1e-9);
}

TEST(Spread, LeavesWhatAnySheetTakesToTheBit) {
  // A shallow bowl: 0.1 % of stretch.
  const Patch patch(meshes::height_field(12, 12, [](double x, double y) {
    return 0.004 * ((x - 6.0) * (x - 6.0) + (y - 6.0) * (y - 6.0));
  }));
  const Pattern least = least_stretch(patch);
  const double peak = edge_strain(patch, least.positions).p99;
  EXPECT_GT(peak, 2e-4);
  EXPECT_LT(peak, 2e-3);
  EXPECT_EQ(unfold(patch).positions, least.positions);
}

TEST(Spread, LeavesAFlattenablePatchToTheBit) {
  const Patch patch(make_shape("cone", 400));
  EXPECT_EQ(unfold(patch).positions, least_stretch(patch).positions);
}

TEST(Spread, GivesTheSameBitsForEveryNumberOfThreads) {
  const Patch patch(make_shape("panel", 3000));
  EXPECT_EQ(unfold(patch, {}, {.threads = 1}).positions,
            unfold(patch, {}, {.threads = 3}).positions);
}

}  // namespace
}  // namespace planish
