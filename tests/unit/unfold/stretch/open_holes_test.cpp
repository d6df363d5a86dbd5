#include "unfold/stretch/open_holes.h"

#include <cmath>
#include <optional>

#include <planish/mesh/patch.h>
#include <planish/unfold/unfold.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "unfold/start/start.h"

namespace planish {
namespace {

/// A hill with a hole of five by three cells.
Patch hill_with_a_hole() {
  TriMesh mesh = meshes::height_field(
      24, 20, [](double x, double y) { return 4.0 * std::sin(x / 8.0) * std::cos(y / 9.0); });
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    const Vec3 middle =
        1.0 / 3.0 * (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]);
    return middle.x > 9.0 && middle.x < 14.0 && middle.y > 8.0 && middle.y < 11.0;
  });
  return Patch(mesh);
}

// Where the holes of least stretch do not cross themselves, the covers get in the way of nothing:
// the rounds come near to the least there is.
TEST(OpenHoles, LeadToLeastStretchWhereNoHoleCrossesItself) {
  const Patch patch = hill_with_a_hole();
  ASSERT_EQ(patch.border_loops().size(), 2U);
  const Disk disk = make_disk(patch);
  const std::optional<Disk> filled = with_holes_filled(disk, patch);
  ASSERT_TRUE(filled);
  ThreadPool pool({.threads = 1});
  StretchSystem system(disk, pool);
  std::vector<Vec2> start = tutte_start(*filled, pool);
  std::vector<Vec2> of_disk(start.begin(),
                            start.begin() + static_cast<std::ptrdiff_t>(disk.vertex_count));
  ASSERT_TRUE(all_upright(disk, of_disk));
  const LeastStretch least = minimise_stretch(disk, system, of_disk, 200, {});
  ASSERT_FALSE(border_crosses_itself(disk, least.flat));

  const auto open = with_open_holes(disk, *filled, std::move(start), 200, pool, {});
  ASSERT_TRUE(open);
  EXPECT_FALSE(border_crosses_itself(disk, open->flat));
  EXPECT_TRUE(all_upright(disk, open->flat));
  EXPECT_TRUE(holes_are_open(disk, open->flat));
  EXPECT_LE(total_energy(disk, open->flat), 1.05 * total_energy(disk, least.flat));
  EXPECT_GE(total_energy(disk, open->flat), (1.0 - 1e-6) * total_energy(disk, least.flat));
}

TEST(OpenHoles, NeedHoles) {
  const Patch patch(meshes::flat_grid(4, 4));
  EXPECT_FALSE(with_holes_filled(make_disk(patch), patch));
}

}  // namespace
}  // namespace planish
