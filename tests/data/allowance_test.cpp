// Allowances around the patterns of real patches, of the folder that PLANISH_TEST_DATA tells.

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include <planish/io/read_mesh.h>
#include <planish/pattern/allowance.h>
#include <planish/unfold/unfold.h>

#include <gtest/gtest.h>

#include "oracle/outline_distance.h"
#include "support/test_patches.h"

namespace planish {
namespace {

/// Tries all kinds of corners at 10 mm around a pattern brought to 600 mm.
void expect_allowances_at_their_distance(const Connectivity& connectivity,
                                         const std::vector<Vec2>& pattern, double width,
                                         const std::string& name) {
  std::vector<Vec2> positions;
  for (const Vec2 p : pattern)
    positions.push_back(600.0 / width * p);
  const PieceOutline outline = piece_outline(connectivity.border_loops(), positions, name);
  for (const Corners corners : {Corners::round, Corners::square, Corners::mitre}) {
    const auto cut = offset_outline(outline, {.width = 10.0, .corners = corners});
    const auto range = oracle::distances(cut, outline.loops);
    const double reach = corners == Corners::round    ? 10.0001
                         : corners == Corners::square ? 14.2
                                                      : 25.0001;
    EXPECT_GT(range.least, 10.0 - 0.0051) << name << ' ' << to_string(corners);
    EXPECT_LT(range.most, reach) << name << ' ' << to_string(corners);
    EXPECT_FALSE(oracle::any_cross(cut)) << name << ' ' << to_string(corners);
  }
}

TEST(Patches, HaveAllowancesAtTheirDistance) {
  for (const PatchFacts& facts : patches()) {
    if (facts.vertices > 30'000) continue;  // slow to unfold
    const TriMesh mesh = read_mesh(facts.path).mesh;
    const Patch patch(mesh);
    if (patch.border_loops().size() != 1) continue;
    const Pattern pattern = unfold(patch);
    if (pattern.overlaps) continue;
    expect_allowances_at_their_distance(patch.connectivity(), pattern.positions, pattern.width,
                                        facts.name);
  }
}

/// Of the folders of `flatten` in the folder that PLANISH_TEST_PATTERNS tells.
TEST(Patches, HaveAllowancesAtTheirDistanceOnceEvolved) {
  const char* folder = std::getenv("PLANISH_TEST_PATTERNS");
  if (folder == nullptr) return;
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().stem() != "flat") continue;
    const TriMesh flat = read_mesh(entry.path()).mesh;
    std::vector<Vec2> pattern;
    double width = 0.0;  // patterns begin at x = 0
    for (const Vec3 p : flat.positions) {
      pattern.push_back({p.x, p.y});
      width = std::max(width, p.x);
    }
    expect_allowances_at_their_distance(Patch(flat).connectivity(), pattern, width,
                                        entry.path().string());
    ++count;
  }
  EXPECT_GT(count, 0U) << "no flat.obj or flat.ply in " << folder;
}

}  // namespace
}  // namespace planish
