#include <algorithm>
#include <cmath>

#include <planish/core/error.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/shapes.h>
#include <planish/unfold/suggest_cuts.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/ringed_disk.h"
#include "support/watched_job.h"

namespace planish {
namespace {

CutSuggestion suggest(const TriMesh& mesh, const SuggestOptions& options = {}) {
  return suggest_cuts(Patch(mesh), options);
}

/// A paraboloid over a disk, or with `saddle` a saddle: vertex 0 in the middle, rings around it.
TriMesh bowl(std::size_t around, std::size_t rings, double depth, bool saddle = false) {
  const auto radius = static_cast<double>(rings);
  TriMesh mesh = meshes::ringed_disk(around, rings, [&](double r, double angle) {
    return depth * r * r / radius * (saddle ? std::cos(2.0 * angle) : 1.0);
  });
  for (Vec3& p : mesh.positions)
    p = 1.0 / radius * p;
  return mesh;
}

/// A bowl pulled straight to a cone.
TriMesh pointed(std::size_t around, std::size_t rings, double depth) {
  TriMesh mesh = bowl(around, rings, 0.0);
  for (Vec3& p : mesh.positions)
    p.z = -depth * std::hypot(p.x, p.y);
  return mesh;
}

double strain_of(const TriMesh& mesh, const CutSuggestion& suggestion, const StrainLimits& limits) {
  std::vector<CutPath> paths;
  for (const SuggestedCut& cut : suggestion.cuts)
    paths.push_back({cut.path});
  const CutMesh cut = cut_open(Patch(mesh), paths);
  const Patch patch(cut.mesh);
  return edge_strain(patch, unfold(patch, {.least_stretch = true, .limits = limits}).positions).max;
}

TEST(SuggestCuts, FindsTheApexOfACone) {
  const TriMesh cone = pointed(24, 8, 0.8);
  const CutSuggestion suggestion = suggest(cone);
  ASSERT_EQ(suggestion.cuts.size(), 1U);
  const SuggestedCut& dart = suggestion.cuts.front();
  EXPECT_TRUE(dart.is_dart);
  EXPECT_TRUE(suggestion.met());
  EXPECT_EQ(dart.before->max, suggestion.first.strain.max);
  EXPECT_GT(dart.before->max, 0.02);
  EXPECT_LE(dart.after->max, 0.02);
  // Up the side, straight; perhaps not all the way, as a limit of 2 % leaves room.
  EXPECT_TRUE(Patch(cone).is_border(dart.path.front()));
  EXPECT_NEAR(dart.length,
              norm(cone.positions[dart.path.front()] - cone.positions[dart.path.back()]), 1e-12);
  const CutSuggestion strict = suggest(cone, {.limits = {.max = 1e-6}});
  ASSERT_EQ(strict.cuts.size(), 1U);
  EXPECT_EQ(strict.cuts.front().path.back(), 0U);
  EXPECT_LT(strict.last.strain.max, 1e-9);
}

TEST(SuggestCuts, KeepsALimitOnMostOfTheAreaWithFewerCuts) {
  const TriMesh mesh = bowl(40, 12, 0.35);
  const CutSuggestion every = suggest(mesh, {.limits = {.max = 0.02}, .max_darts = 8});
  const CutSuggestion most = suggest(mesh, {.limits = {.p99 = 0.02}, .max_darts = 8});
  EXPECT_TRUE(most.met());
  EXPECT_GT(most.first.strain.p99, 0.02);
  EXPECT_LE(most.last.strain.p99, 0.02);
  EXPECT_GT(most.last.strain.max, 0.02);
  EXPECT_LT(most.last.cut.length, every.last.cut.length);
}

TEST(SuggestCuts, GivesTheStrainThatItTells) {
  const TriMesh mesh = bowl(40, 12, 0.35);
  const CutSuggestion suggestion = suggest(mesh, {.limits = {.max = 0.03}, .max_darts = 8});
  EXPECT_TRUE(suggestion.met()) << suggestion.last.strain.max;
  EXPECT_GT(suggestion.first.strain.max, 0.03);
  EXPECT_EQ(strain_of(mesh, suggestion, {.max = 0.03}), suggestion.last.strain.max);
  EXPECT_EQ(suggestion.cuts.back().after->max, suggestion.last.strain.max);
  double length = 0.0;
  for (std::size_t k = 0; k < suggestion.cuts.size(); ++k) {
    length += suggestion.cuts[k].length;
    // Evening out, after the last one, costs some rms strain.
    const bool is_last = k + 1 == suggestion.cuts.size();
    const EdgeStrain &before = *suggestion.cuts[k].before, &after = *suggestion.cuts[k].after;
    EXPECT_LT(is_last ? after.max : after.rms, is_last ? before.max : before.rms);
    if (k > 0) {
      EXPECT_EQ(suggestion.cuts[k].before->rms, suggestion.cuts[k - 1].after->rms);
    }
  }
  EXPECT_NEAR(length, suggestion.last.cut.length, 1e-12);
}

TEST(SuggestCuts, NeedsNoneWhereAPatternThatIsEvenedOutKeepsTheLimit) {
  const TriMesh mesh = bowl(40, 12, 0.35);
  const double least_stretch = strain_of(mesh, {}, {});
  const CutSuggestion suggestion = suggest(mesh, {.limits = {.max = 0.7 * least_stretch}});
  EXPECT_TRUE(suggestion.met());
  EXPECT_TRUE(suggestion.cuts.empty());
  EXPECT_LE(suggestion.last.strain.max, 0.7 * least_stretch);
  EXPECT_EQ(strain_of(mesh, suggestion, {.max = 0.7 * least_stretch}), suggestion.last.strain.max);
}

TEST(SuggestCuts, IsTheSameEveryTimeAlsoByWayOfACoarsePatch) {
  const TriMesh dome = make_shape("dome", 1500);
  const SuggestOptions options = {.limits = {.max = 0.05}, .max_darts = 2, .trial_vertices = 400};
  const CutSuggestion a = suggest(dome, options), b = suggest(dome, options);
  ASSERT_EQ(a.cuts.size(), 2U);
  ASSERT_EQ(b.cuts.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k)
    EXPECT_EQ(a.cuts[k].path, b.cuts[k].path);
  EXPECT_EQ(a.last.pattern.positions, b.last.pattern.positions);
  EXPECT_LT(a.last.strain.max, 0.6 * a.first.strain.max);
}

TEST(SuggestCuts, NeedsNoneWhereTheLimitIsKept) {
  const CutSuggestion suggestion = suggest(make_shape("cylinder", 300));
  EXPECT_TRUE(suggestion.met());
  EXPECT_TRUE(suggestion.cuts.empty());
  EXPECT_EQ(suggestion.last.cut.edges, 0U);
}

TEST(SuggestCuts, OpensTubesAndClosedSurfaces) {
  const TriMesh tube = meshes::tube(12, 5);
  const CutSuggestion opened = suggest(tube);
  ASSERT_EQ(opened.cuts.size(), 1U);
  EXPECT_FALSE(opened.cuts.front().is_dart);
  EXPECT_FALSE(opened.cuts.front().before);
  EXPECT_EQ(opened.cuts.front().length, 5.0);
  EXPECT_TRUE(opened.met());
  EXPECT_LT(opened.last.strain.max, 1e-9);
  for (const TriMesh& closed : {meshes::tetrahedron()}) {
    const CutSuggestion net = suggest(closed, {.max_darts = 0});
    ASSERT_EQ(net.cuts.size(), 1U);
    EXPECT_FALSE(blocking_problem(inspect(net.last.cut.mesh), Purpose::unfold));
  }
}

TEST(SuggestCuts, JoinsSeveralBorders) {
  const TriMesh plate = meshes::plate_with_two_holes();
  EXPECT_EQ(inspect(plate).topology.border_loops, 3U);
  const CutSuggestion joined = suggest(plate);
  EXPECT_EQ(joined.cuts.size(), 2U);
  EXPECT_EQ(joined.last.cut.length, 4.0);
  EXPECT_TRUE(joined.met());
}

TEST(SuggestCuts, SuggestsNoDartThatMakesThePatternOverlap) {
  // Around the middle of a saddle there is more surface than fits into the plane.
  const TriMesh saddle = bowl(40, 12, 0.4, true);
  const CutSuggestion suggestion = suggest(saddle, {.limits = {.max = 0.02}, .max_darts = 3});
  EXPECT_FALSE(suggestion.first.pattern.overlaps);
  EXPECT_FALSE(suggestion.last.pattern.overlaps);
  EXPECT_EQ(suggestion.stop, SuggestStop::overlap);
  EXPECT_EQ(to_string(SuggestStop::overlap), "overlap");
  ASSERT_TRUE(suggestion.divide_at);
  EXPECT_LT(norm(saddle.positions[*suggestion.divide_at]), 0.5) << "the middle";
}

TEST(SuggestCuts, SaysWhyItEnds) {
  const TriMesh dome = make_shape("dome", 150);
  EXPECT_EQ(suggest(dome, {.limits = {.max = 0.001}, .max_darts = 1}).stop,
            SuggestStop::dart_limit);
  EXPECT_EQ(suggest(dome, {.max_darts = 0}).stop, SuggestStop::dart_limit);
  EXPECT_EQ(suggest(dome, {.limits = {.max = 1e-12}, .max_darts = 50}).stop, SuggestStop::no_gain);
  EXPECT_EQ(suggest(dome, {.limits = {.max = 0.9}}).stop, SuggestStop::strain_met);
  EXPECT_EQ(to_string(SuggestStop::no_gain), "no_gain");
}

TEST(SuggestCuts, RefusesWhatIsNoLimit) {
  const TriMesh dome = make_shape("dome", 150);
  for (const double wrong : {std::nan(""), 0.0, -0.02, 2.0, HUGE_VAL})
    EXPECT_THROW(suggest(dome, {.limits = {.max = wrong}}), Error) << wrong;
}

TEST(SuggestCuts, ReportsRisingProgressAndCanBeCancelled) {
  const Patch dome(make_shape("dome", 300));
  expect_cancellable(
      [&](const Context& context) { suggest_cuts(dome, {.limits = {.max = 1e-6}}, context); }, 4);
}

TEST(SuggestCuts, RefusesWhatItCannotOpen) {
  const auto code_of = [](const TriMesh& mesh, const SuggestOptions& options = {}) {
    try {
      suggest_cuts(Patch(mesh), options);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::file_not_found;
  };
  EXPECT_EQ(code_of(meshes::side_by_side(meshes::fan(5), meshes::fan(6))),
            ErrorCode::several_components);
  EXPECT_EQ(code_of(meshes::fan(5), {.limits = {.max = 0.0}}), ErrorCode::option_out_of_range);
  EXPECT_EQ(code_of(meshes::fan(5), {.max_darts = -1}), ErrorCode::option_out_of_range);
}

}  // namespace
}  // namespace planish
