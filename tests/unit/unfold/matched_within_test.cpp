// Patterns whose seams match, spread and within limits.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <planish/core/error.h>
#include <planish/mesh/shapes.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/watched_job.h"
#include "unfold/disk/disk.h"
#include "unfold/stretch/seam_system.h"

namespace planish {
namespace {

using Edges = std::vector<std::array<Index, 2>>;

Pattern matched_least(const Patch& patch) {
  return unfold(patch, {.match_seams = true, .least_stretch = true});
}

/// The second half of the border, as it is walked.
Edges half_of_border(const Patch& patch) {
  const std::vector<Index>& loop = patch.border_loops().front();
  Edges edges;
  for (std::size_t k = loop.size() / 2; k + 1 < loop.size(); ++k)
    edges.push_back({loop[k], loop[k + 1]});
  return edges;
}

TEST(MatchedSpread, LowersThePeaksWithinItsBudgetAndKeepsEveryLength) {
  for (const char* shape : {"panel", "saddle"}) {
    const Patch patch(make_shape(shape, 600));
    const EdgeStrain least = edge_strain(patch, matched_least(patch).positions);
    const Pattern pattern = unfold(patch, {.match_seams = true});
    const EdgeStrain spread = edge_strain(patch, pattern.positions);
    EXPECT_LT(spread.p99, 0.9 * least.p99) << shape;
    EXPECT_LT(spread.max, 0.9 * least.max) << shape;
    EXPECT_LE(spread.rms, k_spread_budget * least.rms) << shape;
    EXPECT_LT(largest_border_strain(patch, pattern.positions), 1e-9) << shape;
    EXPECT_EQ(pattern.flipped_triangles, 0U) << shape;
    EXPECT_FALSE(pattern.overlaps) << shape;
    EXPECT_EQ(pattern.unmatched_least_stretch.size(), patch.vertex_count());
  }
}

TEST(MatchedSpread, UsesItsBudget) {
  const Patch patch(make_shape("panel", 600));
  const EdgeStrain least = edge_strain(patch, matched_least(patch).positions);
  const EdgeStrain spread = edge_strain(patch, unfold(patch, {.match_seams = true}).positions);
  EXPECT_GT(spread.rms, 0.99 * k_spread_budget * least.rms);
}

TEST(MatchedSpread, HoldsOnlyEdgesThatAreNotFree) {
  const Patch patch(make_shape("panel", 600));
  const Edges free = half_of_border(patch);
  const Pattern pattern = unfold(patch, {.match_seams = true, .free_edges = free});
  EXPECT_LT(largest_border_strain(patch, pattern.positions, free), 1e-9);
  EXPECT_GT(largest_border_strain(patch, pattern.positions), 1e-3);
  const EdgeStrain held = edge_strain(patch, unfold(patch, {.match_seams = true}).positions);
  EXPECT_LT(edge_strain(patch, pattern.positions).rms, held.rms);
}

TEST(MatchedSpread, KeepsALimitOfRmsThatThePatternOfLeastStretchKeeps) {
  const Patch patch(make_shape("panel", 600));
  const double least = edge_strain(patch, matched_least(patch).positions).rms;
  const double limit = 1.02 * least;
  const Pattern pattern = unfold(patch, {.match_seams = true, .limits = {.rms = limit}});
  const double rms = edge_strain(patch, pattern.positions).rms;
  EXPECT_LE(rms, limit);
  EXPECT_GT(rms, 1.01 * least) << "it spreads as far as the limit lets it";
}

TEST(MatchedSpread, GivesTheSameBitsForEveryNumberOfThreads) {
  const Patch patch(make_shape("panel", 3000));
  for (const StrainLimits& limits : {StrainLimits{}, StrainLimits{.max = 0.03}}) {
    const auto positions = [&](unsigned threads) {
      return unfold(patch, {.match_seams = true, .limits = limits}, {.threads = threads}).positions;
    };
    EXPECT_EQ(positions(1), positions(3));
  }
}

TEST(MatchedLimits, KeepBothWhereBothCanBeHad) {
  for (const char* shape : {"panel", "saddle"}) {
    const Patch patch(make_shape(shape, 600));
    const EdgeStrain least = edge_strain(patch, matched_least(patch).positions);
    for (const Edges& free : {Edges{}, half_of_border(patch)}) {
      const double limit = 0.7 * least.max;
      const Pattern pattern =
          unfold(patch, {.match_seams = true, .free_edges = free, .limits = {.max = limit}});
      const EdgeStrain strain = edge_strain(patch, pattern.positions);
      EXPECT_LE(strain.max, limit) << shape;
      EXPECT_LT(largest_border_strain(patch, pattern.positions, free), 1e-9) << shape;
      EXPECT_EQ(pattern.flipped_triangles, 0U) << shape;
      EXPECT_EQ(pattern.unmatched_least_stretch.size(), patch.vertex_count());
      if (!free.empty()) continue;
      ASSERT_EQ(pattern.least_stretch.size(), patch.vertex_count());
      EXPECT_NEAR(edge_strain(patch, pattern.least_stretch).max, least.max, 1e-9)
          << "compared with those that match";
    }
  }
}

TEST(MatchedLimits, LeaveAPatternThatKeepsThemAsItIs) {
  const Patch patch(make_shape("panel", 600));
  const Pattern least = matched_least(patch);
  const double limit = 1.01 * edge_strain(patch, least.positions).max;
  const Pattern pattern =
      unfold(patch, {.match_seams = true, .least_stretch = true, .limits = {.max = limit}});
  EXPECT_EQ(pattern.positions, least.positions);
  EXPECT_TRUE(pattern.least_stretch.empty());
}

TEST(MatchedLimits, FreeNoSewnEdgeForThe99Percent) {
  const Patch patch(make_shape("panel", 1500));
  const EdgeStrain least = edge_strain(patch, matched_least(patch).positions);
  // So little that not every edge can keep it.
  const Pattern all = unfold(patch, {.match_seams = true, .limits = {.max = 0.3 * least.p99}});
  const double smallest = edge_strain(patch, all.positions).max;
  const double limit = 0.97 * smallest;
  const Pattern pattern = unfold(patch, {.match_seams = true, .limits = {.p99 = limit}});
  const EdgeStrain strain = edge_strain(patch, pattern.positions);
  EXPECT_LE(strain.p99, limit);
  EXPECT_GT(strain.max, limit) << "some are freed";
  EXPECT_LT(largest_border_strain(patch, pattern.positions), 1e-9);
}

TEST(MatchedLimits, KeepTheSeamsAndTellThatTheyAreMissedWhereBothCannotBeHad) {
  const Patch dome(make_shape("dome", 400));
  const StrainLimits limits{.max = 0.3 * edge_strain(dome, unfold(dome).positions).max};
  const Pattern pattern = unfold(dome, {.match_seams = true, .limits = limits});
  EXPECT_LT(largest_border_strain(dome, pattern.positions), 1e-9);
  EXPECT_FALSE(all_kept(check_limits(dome, pattern.positions, limits)));
  EXPECT_LT(edge_strain(dome, pattern.positions).max,
            edge_strain(dome, matched_least(dome).positions).max)
      << "as near as it gets";
}

/// The border of half a body with a waist, which least stretch makes shorter, gets no teeth.
TEST(MatchedLimits, BendTheBorderWithoutTeeth) {
  TriMesh mesh = meshes::flat_grid(24, 48);
  for (Vec3& p : mesh.positions) {
    const double angle = std::numbers::pi * p.x / 24.0, z = p.y / 24.0 - 1.0;
    const double radius = 1.0 - 0.35 * std::exp(-std::pow(z / 0.35, 2.0));
    p = {radius * std::cos(angle), radius * std::sin(angle), 1.5 * z};
  }
  const Patch patch(mesh);
  const std::vector<Index>& loop = patch.border_loops().front();
  const auto turn = [&](const std::vector<Vec2>& flat, std::size_t k) {
    const std::size_t n = loop.size();
    const Vec2 before = flat[loop[k]] - flat[loop[(k + n - 1) % n]];
    const Vec2 after = flat[loop[(k + 1) % n]] - flat[loop[k]];
    return std::atan2(cross(before, after), dot(before, after));
  };
  const Pattern least = matched_least(patch);
  const double limit = 0.8 * edge_strain(patch, least.positions).max;
  for (const StrainLimits& limits : {StrainLimits{}, StrainLimits{.max = limit}}) {
    const Pattern pattern = unfold(patch, {.match_seams = true, .limits = limits});
    double most = 0.0;
    for (std::size_t k = 0; k < loop.size(); ++k)
      most = std::max(
          most, std::abs(turn(pattern.positions, k) - turn(pattern.unmatched_least_stretch, k)));
    EXPECT_LT(most, 0.15) << "teeth turn by more than a radian";
  }
}

TEST(MatchedLimits, ReportEveryStepAndCanBeCancelledAfterAny) {
  const Patch panel(make_shape("panel", 800));
  const double limit = 0.7 * edge_strain(panel, matched_least(panel).positions).max;
  for (const StrainLimits& limits : {StrainLimits{}, StrainLimits{.max = limit}}) {
    WatchedJob job;
    const Pattern pattern = unfold(panel, {.match_seams = true, .limits = limits}, job.context());
    EXPECT_EQ(job.reports(), pattern.iterations);
    expect_cancellable([&](const Context& context) {
      unfold(panel, {.match_seams = true, .limits = limits}, context);
    });
  }
}

/// So long and narrow that numbers cannot tell whether its ends keep their lengths.
TriMesh ribbon() {
  TriMesh mesh = meshes::flat_grid(12, 2);
  for (Vec3& p : mesh.positions)
    p = {1e8 * p.x, 0.7 * p.y, 0.1 * p.x * p.y};
  return mesh;
}

TEST(MatchIfPossible, LeavesUnmatchedWhatCannotKeepItsBorder) {
  const Patch patch(ribbon());
  const Pattern pattern = unfold(patch, {.match_seams = true, .match_if_possible = true});
  EXPECT_TRUE(pattern.is_unmatchable);
  EXPECT_TRUE(pattern.unmatched_least_stretch.empty());
  EXPECT_EQ(pattern.positions, unfold(patch).positions) << "as without matching";
  try {
    unfold(patch, {.match_seams = true});
    ADD_FAILURE() << "where seams must match, this is an error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::unfold_failed);
  }
}

TEST(MatchIfPossible, IsIdleWhereTheBorderKeepsItsLengths) {
  const Patch patch(make_shape("saddle", 400));
  const Pattern pattern = unfold(patch, {.match_seams = true, .match_if_possible = true});
  EXPECT_FALSE(pattern.is_unmatchable);
  EXPECT_EQ(pattern.positions, unfold(patch, {.match_seams = true}).positions);
}

/// A dome's disk, flat with matched borders.
struct FlatDome {
  FlatDome() {
    for (const Index v : disk.vertex_of)
      flat.push_back(disk.area_scale * (disk.box_scale * pattern.positions[v]));
    flat = turn_to_axis(disk, flat);
  }

  Patch patch{make_shape("dome", 200)};
  Pattern pattern = matched_least(patch);
  Disk disk = make_disk(patch);
  std::vector<Vec2> flat;
  ThreadPool alone{1};
};

TEST(SeamSystem, RestoresLengthsThatAMoveLost) {
  FlatDome dome;
  const HeldBorder border(dome.disk, BorderLengths{border_lengths(dome.patch.mesh(), dome.disk)},
                          dome.flat);
  SeamSystem system(dome.disk, border, dome.alone);
  system.assemble(dome.flat, Curvature::projected);
  ASSERT_TRUE(system.factor());
  meshes::Random random(5);
  std::vector<Vec2> lost = dome.flat;
  for (Vec2& p : lost)
    p = p + 1e-3 * Vec2{random.number(), random.number()};
  EXPECT_FALSE(system.all_kept(system.gaps(lost)));
  const auto found = system.restored(lost);
  ASSERT_TRUE(found);
  EXPECT_TRUE(system.all_kept(system.gaps(*found)));
  double most = 0.0;
  for (std::size_t v = 0; v < lost.size(); ++v)
    most = std::max(most, norm((*found)[v] - lost[v]));
  EXPECT_LT(most, 0.1) << "near to where it was";
  for (Vec2& p : lost)
    p = {0.1 * p.x, 5.0 * p.y};
  EXPECT_FALSE(system.restored(lost)) << "too far away";
}

TEST(HeldBorder, EliminatesEveryVertexOnce) {
  FlatDome dome;
  const HeldBorder border(dome.disk, BorderLengths{border_lengths(dome.patch.mesh(), dome.disk)},
                          dome.flat);
  std::vector<Index> sorted = border.order;
  std::sort(sorted.begin(), sorted.end());
  ASSERT_EQ(sorted.size(), dome.disk.vertex_count);
  for (std::size_t v = 0; v < sorted.size(); ++v)
    EXPECT_EQ(sorted[v], v);
}

}  // namespace
}  // namespace planish
