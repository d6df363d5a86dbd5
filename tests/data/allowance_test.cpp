// Allowances around the patterns of real patches, of the folder that PLANISH_TEST_DATA tells.

#include <algorithm>

#include <planish/io/read_mesh.h>
#include <planish/pattern/offset_outline.h>
#include <planish/unfold/unfold.h>

#include <gtest/gtest.h>

#include "oracle/outline_distance.h"
#include "support/test_patches.h"

namespace planish {
namespace {

TEST(Patches, HaveAllowancesAtTheirDistance) {
  for (const PatchFacts& facts : patches()) {
    if (facts.vertices > 30'000) continue;  // slow to unfold
    const TriMesh mesh = read_mesh(facts.path).mesh;
    const Connectivity connectivity(mesh);
    if (connectivity.border_loops().size() != 1) continue;
    const Pattern pattern = unfold(mesh, connectivity);
    if (pattern.overlaps) continue;
    std::vector<Vec2> positions;
    for (const Vec2 p : pattern.positions)
      positions.push_back(600.0 / pattern.width * p);
    const PieceOutline outline = piece_outline(connectivity.border_loops(), positions, facts.name);
    for (const Corners corners : {Corners::round, Corners::square, Corners::mitre}) {
      const auto cut = offset_outline(outline, {.width = 10.0, .corners = corners});
      const auto range = oracle::distances(cut, outline.loops);
      const double reach = corners == Corners::round    ? 10.0001
                           : corners == Corners::square ? 14.2
                                                        : 25.0001;
      EXPECT_GT(range.least, 10.0 - 0.0051) << facts.name << ' ' << to_string(corners);
      EXPECT_LT(range.most, reach) << facts.name << ' ' << to_string(corners);
      EXPECT_FALSE(oracle::any_cross(cut)) << facts.name << ' ' << to_string(corners);
    }
  }
}

}  // namespace
}  // namespace planish
