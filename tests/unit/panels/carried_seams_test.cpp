#include "panels/carried_seams.h"

#include <algorithm>
#include <numeric>

#include <planish/mesh/carry.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "panels/cells/thinned_product.h"
#include "panels/divided_piece.h"
#include "support/meshes.h"
#include "support/solids.h"

namespace planish {
namespace {

TEST(CarriedSeams, DivideTheProductAsTheThinnedOne) {
  const Patch product(solids::sphere(1.0, 48));
  ThreadPool pool(2);
  const PanelMesh thin(thinned_product(product, 600, pool));
  const Division division = divided(thin, {}, 0.03, {}, {.cells = 30}, pool);
  const CarriedSeams carried = carried_seams(product, *division.net, division.state.open(), 0.01);
  const OpenEdges& open = carried.open;
  EXPECT_EQ(open_parts(carried.net.mesh, open).size(), division.state.piece_count());
  for (std::size_t e = 0; e < open.size(); ++e)
    EXPECT_LE(open[e], carried.net.seams[e]);
  // Straighter, so not longer; by up to 0.7 edges of a coarse mesh.
  const double thin_length = open_length(division.net->mesh, division.state.open());
  EXPECT_LT(open_length(carried.net.mesh, open), 1.01 * thin_length);
  EXPECT_GT(open_length(carried.net.mesh, open), 0.8 * thin_length);
  const SeamState state(carried.net.mesh, open, pool);
  for (const PanelPiece& piece : state.pieces())
    EXPECT_LT(piece.strain(), 1.2 * 0.03);
}

/// How many edges stay open along a line over the middle of a mesh.
std::size_t left_open(const Patch& patch, Vec3 from, Vec3 to) {
  const std::vector<SurfaceLine> line = trace_lines(patch, {{{{from, to}, {}}}, {}}).lines;
  const std::vector<unsigned char> is_open(line.size(), 1);
  const OpenEdges open = imprinted_seams(patch, line, is_open, 0.01).open;
  return static_cast<std::size_t>(std::count(open.begin(), open.end(), 1));
}

TEST(ImprintedSeams, CloseSlitsThatMeetNeitherTheBorderNorAnother) {
  const Patch sheet(meshes::flat_grid(8, 8));
  EXPECT_EQ(left_open(sheet, {2, 3, 0}, {5, 4, 0}), 0U);
  EXPECT_GT(left_open(sheet, {0, 3, 0}, {5, 4, 0}), 4U);
  // A slit is all that a closed surface has.
  EXPECT_GT(left_open(Patch(solids::sphere(1.0, 24)), {1, 0, 0}, {0.8, 0.6, 0}), 2U);
}

TEST(DividedPiece, IsTwoPieces) {
  const Patch dome(make_shape("dome", 1000));
  PanelMesh mesh(dome);
  const OpenEdges none(mesh.edges().size(), 0);
  std::vector<std::vector<Index>> pieces(1, std::vector<Index>(mesh.triangles().size()));
  std::iota(pieces[0].begin(), pieces[0].end(), Index{0});
  ThreadPool pool(1);
  const SeamNet whole{std::move(mesh), none, {}};
  const CarriedSeams halves = with_pieces_divided(whole, none, pieces, 0.01, pool);
  const SeamState state(halves.net.mesh, halves.open, pool);
  EXPECT_EQ(state.piece_count(), 2U);
  EXPECT_EQ(state.tips(), 0U);
  EXPECT_EQ(halves.open, halves.net.seams);
}

}  // namespace
}  // namespace planish
