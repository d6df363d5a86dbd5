#include "unfold/stretch/held_border.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

struct FlatGrid {
  TriMesh mesh = meshes::rough_grid(5, 4, 7, 0.2, 0.3);
  Disk disk = make_disk(Patch(mesh));
  BorderLengths lengths{border_lengths(mesh, disk)};
  std::vector<Vec2> flat = std::vector<Vec2>(disk.vertex_count);

  FlatGrid() {
    for (std::size_t v = 0; v < flat.size(); ++v) {
      const Vec3 p = mesh.positions[disk.vertex_of[v]];
      flat[v] = {p.x, p.y};
    }
  }
};

TEST(HeldBorder, BendsAtNoCostAsThePatternDoes) {
  const FlatGrid grid;
  const TurnBending bend = HeldBorder(grid.disk, grid.lengths, grid.flat).bend;
  EXPECT_EQ(bend.turns().size(), grid.disk.border.size());
  EXPECT_EQ(bend.value(grid.flat), 0.0);
}

TEST(HeldBorder, BendsAtTheEndsOfEdgesThatKeepTheirLength) {
  FlatGrid grid;
  const std::size_t n = grid.disk.border.size();
  grid.lengths.is_free.assign(n, 1);
  EXPECT_TRUE(HeldBorder(grid.disk, grid.lengths, grid.flat).bend.turns().empty());
  grid.lengths.is_free[4] = 0;
  const auto turns = HeldBorder(grid.disk, grid.lengths, grid.flat).bend.turns();
  ASSERT_EQ(turns.size(), 2U);
  EXPECT_EQ(turns[0].vertices[1], grid.disk.border[4]);
  EXPECT_EQ(turns[1].vertices[1], grid.disk.border[5]);
}

TEST(HeldBorder, LeavesOutEdgesThatAreMuchShorterThanOthers) {
  FlatGrid grid;
  grid.lengths.of_edges[6] *= 1e-3;
  EXPECT_EQ(HeldBorder(grid.disk, grid.lengths, grid.flat).bend.turns().size(),
            grid.disk.border.size() - 2);
}

}  // namespace
}  // namespace planish
