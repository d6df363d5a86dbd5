#include "mesh/coarsen/coarsen.h"

#include <algorithm>

#include <planish/io/read_mesh.h>

#include <gtest/gtest.h>

#include "support/coarse_patches.h"
#include "support/test_patches.h"

namespace planish {
namespace {

TEST(Coarsen, IsSoundOnRealPatches) {
  for (const PatchFacts& facts : patches()) {
    if (facts.vertices > 30'000) continue;
    SCOPED_TRACE(facts.name);
    const TriMesh mesh = read_mesh(facts.path).mesh;
    const CoarsePatch thin =
        coarse(mesh, std::min<std::size_t>(mesh.positions.size() / 3, 3000), CoarseBorder::thinned);
    expect_sound(mesh, thin);
    EXPECT_LT(farthest(mesh, thin.mesh), 0.02);
    EXPECT_GE(smallest_angles(thin.mesh).front(),
              std::min(5.0, 0.5 * smallest_angles(mesh).front()));
    const CoarsePatch kept = coarse(mesh, mesh.positions.size() / 10, CoarseBorder::kept);
    expect_sound(mesh, kept);
    EXPECT_EQ(loops_in_fine(kept), Patch(mesh).border_loops());
  }
}

}  // namespace
}  // namespace planish
