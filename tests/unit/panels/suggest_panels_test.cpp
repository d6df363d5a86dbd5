#include <algorithm>
#include <atomic>
#include <cmath>

#include <planish/mesh/cut.h>
#include <planish/mesh/shapes.h>
#include <planish/panels/suggest_panels.h>

#include <gtest/gtest.h>

#include "mesh/split.h"
#include "support/meshes.h"
#include "support/solids.h"

namespace planish {
namespace {

TEST(SuggestPanels, DividesAClosedSurfaceWithinTheLimit) {
  const Patch ball(solids::sphere(1.0, 24));
  PanelOptions options;
  options.limits.rms = 0.05;
  options.moves = 2;
  options.trial_vertices = 500;
  std::vector<double> costs;
  options.on_better = [&](const PanelSuggestion& better) { costs.push_back(better.cost); };
  const PanelSuggestion found = suggest_panels(ball, options, {.threads = 2});
  ASSERT_TRUE(found.met);
  ASSERT_FALSE(costs.empty());
  EXPECT_EQ(costs.back(), found.cost);
  double area = 0.0;
  for (const SuggestedPanel& panel : found.panels) {
    EXPECT_TRUE(panel.has_pattern && !panel.overlaps);
    EXPECT_LE(panel.strain.rms, options.limits.rms);
    area += panel.area;
  }
  EXPECT_NEAR(area, 1.0, 1e-9);

  // Cut along its seams, the mesh falls into the panels.
  std::vector<CutPath> paths;
  double length = 0.0;
  for (const std::vector<Index>& seam : found.seams) {
    paths.push_back({seam, {}});
    length += path_length(seam, found.mesh.positions);
  }
  EXPECT_NEAR(length, found.length, 1e-9);
  EXPECT_NEAR(found.cost,
              length / std::sqrt(meshes::area(found.mesh)) +
                  0.25 * static_cast<double>(found.panels.size()),
              1e-9);
  const CutMesh cut = cut_open(Patch(found.mesh), paths);
  EXPECT_EQ(split(cut.mesh, "panel").size(), found.panels.size());

  options.on_better = {};
  const PanelSuggestion again = suggest_panels(ball, options, {.threads = 1});
  EXPECT_EQ(again.seams, found.seams);
  EXPECT_EQ(again.mesh.positions, found.mesh.positions);
}

TEST(SuggestPanels, IsTheSameAtAnySize) {
  const TriMesh one = meshes::finer(solids::cube(), 2);
  for (const TriMesh& mesh : {one, meshes::side_by_side(one, solids::cube())}) {
    const PanelSuggestion found = suggest_panels(Patch(mesh), {.moves = 1});
    for (const int power : {-600, 600}) {
      const double size = std::ldexp(1.0, power);
      std::vector<double> told;
      PanelOptions options{.moves = 1};
      options.on_better = [&](const PanelSuggestion& better) { told.push_back(better.length); };
      const PanelSuggestion other = suggest_panels(Patch(scaled(mesh, size)), options);
      EXPECT_EQ(other.seams, found.seams);
      EXPECT_EQ(other.mesh.positions, scaled(found.mesh, size).positions);
      EXPECT_EQ(other.length, size * found.length);
      EXPECT_EQ(told, std::vector<double>{other.length});
      EXPECT_EQ(other.cost, found.cost);
      EXPECT_EQ(other.met, found.met);
      ASSERT_EQ(other.panels.size(), found.panels.size());
      EXPECT_EQ(other.panels[0].area, found.panels[0].area);
    }
  }
}

TEST(SuggestPanels, LeavesWhatLiesFlatWhole) {
  const PanelSuggestion found = suggest_panels(Patch(make_shape("cylinder", 500)), {.moves = 1});
  EXPECT_TRUE(found.met);
  EXPECT_EQ(found.panels.size(), 1U);
  EXPECT_EQ(found.length, 0.0);
  EXPECT_TRUE(found.seams.empty());
}

TEST(SuggestPanels, MakesNoSlitsWhereSimpleIsPreferred) {
  PanelOptions options;
  options.prefer = PanelPreference::simple;
  options.moves = 1;
  const PanelSuggestion found = suggest_panels(Patch(make_shape("dome", 800)), options);
  EXPECT_TRUE(found.met);
  EXPECT_EQ(found.tips, 0U);
}

TEST(SuggestPanels, RefusesWhatItCannotDivide) {
  const auto code_of = [](const TriMesh& mesh, const PanelOptions& options) {
    try {
      suggest_panels(Patch(mesh), options);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::no_triangles;
  };
  EXPECT_EQ(code_of(solids::cube(), {.limits = {}}), ErrorCode::option_out_of_range);
  EXPECT_EQ(code_of(solids::cube(), {.moves = 0}), ErrorCode::option_out_of_range);
  TriMesh line = meshes::flat_grid(3, 3);
  for (Vec3& p : line.positions)
    p = {p.x + 10.0 * p.y, 0.0, 0.0};
  EXPECT_EQ(code_of(line, {.moves = 1}), ErrorCode::zero_area);
}

TEST(SuggestPanels, DividesPartsAndHandles) {
  const TriMesh cubes = meshes::side_by_side(meshes::finer(solids::cube(), 3), solids::cube());
  PanelOptions options{.limits = {.rms = 1e-3}, .moves = 1};
  std::size_t answers = 0;
  options.on_better = [&](const PanelSuggestion& better) {
    ++answers;
    EXPECT_EQ(better.panels.size(), 2U);
  };
  const PanelSuggestion two = suggest_panels(Patch(cubes), options);
  EXPECT_TRUE(two.met);
  EXPECT_EQ(answers, 1U);
  ASSERT_EQ(two.panels.size(), 2U);
  EXPECT_NEAR(two.panels[0].area + two.panels[1].area, 1.0, 1e-12);
  EXPECT_NEAR(two.length, 2.0 * 7.0 * 2.0, 1e-9);  // 7 of 12 edges make a net
  std::vector<CutPath> paths;
  for (const std::vector<Index>& seam : two.seams)
    paths.push_back({seam, {}});
  EXPECT_EQ(split(cut_open(Patch(two.mesh), paths).mesh, "panel").size(), 2U);

  const PanelSuggestion ring =
      suggest_panels(Patch(meshes::torus(40, 20)), {.limits = {.rms = 0.05}, .moves = 1});
  EXPECT_TRUE(ring.met);
}

TEST(SuggestPanels, HasShorterSeamsWherePiecesCanChange) {
  const Patch dome(make_shape("dome", 800));
  PanelOptions options{.limits = {.rms = 0.02}, .prefer = PanelPreference::shortest, .moves = 2};
  options.trial_vertices = 500;
  options.match_seams = false;
  const PanelSuggestion stiff = suggest_panels(dome, options);
  ASSERT_TRUE(stiff.met);
  options.can_change = [](const Patch&, const Context&) { return false; };
  EXPECT_EQ(suggest_panels(dome, options).seams, stiff.seams);
  std::atomic<std::size_t> most_asked = 0;
  options.can_change = [&](const Patch& piece, const Context&) {
    most_asked = std::max<std::size_t>(most_asked, piece.vertex_count());
    return true;
  };
  const PanelSuggestion soft = suggest_panels(dome, options);
  EXPECT_TRUE(soft.met);
  EXPECT_LT(soft.length, stiff.length);
  EXPECT_GT(most_asked, 0U);
  EXPECT_LT(most_asked, 1000U);
  double largest = 0.0;
  for (const SuggestedPanel& panel : soft.panels) {
    EXPECT_EQ(panel.changes, panel.strain.rms > 0.02);
    largest = std::max(largest, panel.strain.rms);
  }
  EXPECT_GT(largest, 0.02);
  EXPECT_LT(largest, 0.02 * 1.5);
  // What asking throws comes through.
  options.can_change = [](const Patch&, const Context&) -> bool { throw Cancelled(); };
  EXPECT_THROW(suggest_panels(dome, {.limits = {.rms = 0.02}, .can_change = options.can_change}),
               Cancelled);
}

TEST(SuggestPanels, HasTheBestWhenItIsCancelled) {
  bool is_enough = false;
  PanelOptions options;
  options.on_better = [&](const PanelSuggestion&) { is_enough = true; };
  const PanelSuggestion found = suggest_panels(Patch(make_shape("dome", 500)), options,
                                               {.is_cancelled = [&] { return is_enough; }});
  EXPECT_TRUE(found.was_cancelled);
  EXPECT_TRUE(found.met);
}

TEST(SuggestPanels, CanBeCancelled) {
  EXPECT_THROW(
      suggest_panels(Patch(solids::sphere(1.0, 12)), {}, {.is_cancelled = [] { return true; }}),
      Cancelled);
}

}  // namespace
}  // namespace planish
