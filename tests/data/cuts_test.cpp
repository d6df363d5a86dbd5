#include <planish/io/read_features.h>
#include <planish/io/read_mesh.h>
#include <planish/unfold/suggest_cuts.h>

#include <gtest/gtest.h>

#include "support/test_patches.h"

namespace planish {
namespace {

TEST(SuggestCuts, GivesRealPatchesTheStrainThatItTells) {
  for (const PatchFacts& facts : patches()) {
    if (facts.vertices > 5'000) continue;
    SCOPED_TRACE(facts.name);
    const TriMesh mesh = read_mesh(facts.path).mesh;
    const Patch patch(mesh);
    constexpr double limit = 0.02;
    const auto suggestion =
        suggest_cuts(patch, {.limits = {.max = limit}, .max_darts = 2, .trial_vertices = 1500});
    std::vector<std::vector<Index>> paths;
    for (const SuggestedCut& cut : suggestion.cuts) {
      EXPECT_TRUE(cut.after->rms < cut.before->rms || suggestion.met());
      paths.push_back(cut.path);
    }
    if (paths.empty()) continue;
    const CutLines lines = parse_cuts(format_cuts(paths), mesh, "cuts.txt");
    const CutMesh cut = cut_open(patch, lines.paths);
    const Patch opened(cut.mesh);
    // Evened out only where that keeps the limit.
    UnfoldOptions options{.least_stretch = true};
    if (suggestion.met()) options.limits.max = limit;
    const EdgeStrain strain = edge_strain(opened, unfold(opened, options).positions);
    EXPECT_EQ(strain.max, suggestion.last.strain.max);
    EXPECT_EQ(strain.rms, suggestion.last.strain.rms);
  }
}

}  // namespace
}  // namespace planish
