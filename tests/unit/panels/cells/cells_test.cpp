#include <algorithm>
#include <numeric>

#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "panels/cells/merge_cells.h"
#include "panels/cells/normal_cells.h"
#include "panels/cells/thinned_product.h"
#include "panels/cells/tie_lines.h"
#include "panels/piece/piece_strain.h"
#include "panels/seams/seam_chains.h"
#include "support/meshes.h"
#include "support/solids.h"

namespace planish {
namespace {

std::vector<Index> cells_by_normals(const PanelMesh& mesh, std::size_t count) {
  std::vector<Index> all(mesh.triangles().size());
  std::iota(all.begin(), all.end(), Index{0});
  return normal_cells(mesh, all, count);
}

TEST(NormalCells, OfACubeLieOnItsSides) {
  const PanelMesh cube(Patch(meshes::finer(solids::cube(), 3)));
  const std::vector<Index> cells = cells_by_normals(cube, 24);
  const std::size_t a_side = cube.triangles().size() / 6;
  std::vector<std::size_t> side_of(24, 6);
  for (Index t = 0; t < cells.size(); ++t) {
    ASSERT_LT(cells[t], 24U);
    if (side_of[cells[t]] == 6) side_of[cells[t]] = t / a_side;
    EXPECT_EQ(side_of[cells[t]], t / a_side);
  }
}

TEST(NormalCells, AreInOnePartEach) {
  const PanelMesh ball(Patch(solids::sphere(1.0, 20)));
  for (const double place_weight : {0.0, 0.5}) {
    std::vector<Index> all(ball.triangles().size());
    std::iota(all.begin(), all.end(), Index{0});
    const std::vector<Index> cells = normal_cells(ball, all, 9, place_weight);
    EXPECT_EQ(1 + *std::max_element(cells.begin(), cells.end()), 9U);
    EXPECT_EQ(open_parts(ball, open_between(ball, cells)).size(), 9U);
  }
}

TEST(MergeCells, KeepsTheLimitAndShortensSeams) {
  const PanelMesh dome(Patch(make_shape("dome", 1000)));
  const std::vector<Index> cells = cells_by_normals(dome, 30);
  ThreadPool pool(2);
  const double limit = 0.02;
  const std::vector<Index> merged = merge_cells(dome, cells, {.limit = limit}, pool);
  const OpenEdges before = open_between(dome, cells), after = open_between(dome, merged);
  EXPECT_LT(open_length(dome, after), open_length(dome, before));
  for (std::size_t e = 0; e < after.size(); ++e)
    EXPECT_LE(after[e], before[e]);
  const OpenEdges closed(after.size(), 0);
  const auto parts = open_parts(dome, after);
  EXPECT_LT(parts.size(), 30U);
  EXPECT_GT(parts.size(), 1U);
  for (const std::vector<Index>& part : parts)
    EXPECT_LE(measured_piece(dome, closed, part).strain(), limit);
  ThreadPool alone(1);
  EXPECT_EQ(merged, merge_cells(dome, cells, {.limit = limit}, alone));
}

TEST(MergeCells, MakesOnePieceOfWhatLiesFlat) {
  const PanelMesh cylinder(Patch(make_shape("cylinder", 500)));
  ThreadPool pool(1);
  const std::vector<Index> merged =
      merge_cells(cylinder, cells_by_normals(cylinder, 12), {.limit = 0.005}, pool);
  EXPECT_EQ(*std::max_element(merged.begin(), merged.end()), 0U);
}

TEST(TieLines, PartTheCellsThatTheyAreOf) {
  const PanelMesh ball(Patch(solids::sphere(1.0, 24)));
  const std::vector<Index> cells = cells_by_normals(ball, 8);
  ThreadPool pool(2);
  const auto lines = tie_lines(ball, cell_fields(ball, cells, 1.5, pool));
  const CellMesh lined = imprinted_cells(ball.patch(), lines, 0.002);
  EXPECT_EQ(1 + *std::max_element(lined.cells.begin(), lined.cells.end()), 8U);
  // Fair lines are shorter than edges that zigzag.
  EXPECT_LT(open_length(lined.mesh, open_between(lined.mesh, lined.cells)),
            open_length(ball, open_between(ball, cells)));
  // Areas hardly change.
  std::vector<double> areas(8, 0.0);
  for (Index t = 0; t < lined.cells.size(); ++t)
    areas[lined.cells[t]] += lined.mesh.area(t);
  EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0), 1.0, 1e-12);
  EXPECT_GT(*std::min_element(areas.begin(), areas.end()), 0.05);
}

TEST(ThinnedProduct, KeepsTheTopology) {
  ThreadPool pool(1);
  const Patch ball = thinned_product(Patch(solids::sphere(1.0, 40)), 500, pool);
  EXPECT_NEAR(static_cast<double>(ball.vertex_count()), 500.0, 50.0);
  EXPECT_EQ(ball.inspection().topology.border_loops, 0U);
  EXPECT_EQ(ball.inspection().topology.components, 1U);
  const Patch dome = thinned_product(Patch(make_shape("dome", 2000)), 500, pool);
  EXPECT_NEAR(static_cast<double>(dome.vertex_count()), 500.0, 50.0);
  EXPECT_EQ(dome.border_loops().size(), 1U);
}

}  // namespace
}  // namespace planish
