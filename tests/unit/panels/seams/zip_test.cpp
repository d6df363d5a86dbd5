#include "panels/seams/zip.h"

#include <cmath>

#include <gtest/gtest.h>

#include "panels/cells/merge_cells.h"
#include "panels/seams/flat_zip.h"
#include "panels/seams/unzip.h"
#include "support/meshes.h"
#include "support/solids.h"

namespace planish {
namespace {

/// A cube with its twelve edges as seams.
struct SeamedCube {
  static std::vector<Index> sides(const PanelMesh& mesh) {
    std::vector<Index> cells;
    for (std::size_t t = 0; t < mesh.triangles().size(); ++t)
      cells.push_back(static_cast<Index>(t / (mesh.triangles().size() / 6)));
    return cells;
  }
  PanelMesh mesh{Patch(meshes::finer(solids::cube(), 2))};
  OpenEdges seams = open_between(mesh, sides(mesh));
  std::vector<SeamChain> chains = seam_chains(mesh, seams);
};

const double k_cube_edge = 2.0 / std::sqrt(24.0);  // of the root of the area

TEST(SeamChains, OfACubeAreItsEdges) {
  const SeamedCube cube;
  ASSERT_EQ(cube.chains.size(), 12U);
  for (const SeamChain& chain : cube.chains) {
    EXPECT_EQ(chain.edges.size(), 4U);
    EXPECT_EQ(chain.vertices.size(), 5U);
  }
  EXPECT_NEAR(open_length(cube.mesh, cube.seams), 12.0 * k_cube_edge, 1e-12);
}

TEST(SeamChains, MayBeRound) {
  const PanelMesh tube(Patch(meshes::tube(12, 4)));
  std::vector<Index> cells;
  for (const Triangle& t : tube.triangles()) {
    double z = 0.0;
    for (const Index v : t)
      z += tube.patch().positions()[v].z / 3.0;
    cells.push_back(z > 0.5 * tube.patch().positions().back().z ? 1 : 0);
  }
  const auto chains = seam_chains(tube, open_between(tube, cells));
  ASSERT_EQ(chains.size(), 1U);
  EXPECT_EQ(chains[0].vertices.front(), chains[0].vertices.back());
}

TEST(Zip, MakesANetOfACube) {
  // Each corner needs an open edge, and a disk an open tree: seven edges.
  for (const unsigned threads : {1U, 2U}) {
    const SeamedCube cube;
    ThreadPool pool(threads);
    const FlatState net = zipped_flat(SeamState(cube.mesh, cube.seams, pool), cube.chains, 1e-3, {},
                                      {}, OpenEdges(cube.seams.size(), 0), pool);
    EXPECT_TRUE(net.lies_flat);
    EXPECT_EQ(net.state.piece_count(), 1U);
    EXPECT_NEAR(open_length(cube.mesh, net.state.open()), 7.0 * k_cube_edge, 1e-12);
    EXPECT_NEAR(net.state.cost({}), 7.0 * k_cube_edge + 0.25, 1e-12);
  }
}

TEST(Zip, LeavesHeldSeamsOpen) {
  const SeamedCube cube;
  ThreadPool pool(1);
  SeamState state(cube.mesh, cube.seams, pool);
  Zip(cube.chains, 1e-3, {}).run(state, cube.seams);
  EXPECT_EQ(state.open(), cube.seams);
  EXPECT_EQ(state.piece_count(), 6U);
}

TEST(Zip, JoinsOnlyWhatMayBeJoined) {
  const SeamedCube cube;
  ThreadPool pool(1);
  const OpenEdges none(cube.seams.size(), 0);
  SeamState state(cube.mesh, cube.seams, pool);
  Zip(cube.chains, 1e-3, {}, {}, [](const SeamState&, const SeamRun&) {
    return false;
  }).run(state, none);
  EXPECT_EQ(state.piece_count(), 6U);
  // Of three faces that are joined already no more.
  const auto is_small = [&](const SeamState& before, const SeamRun& run) {
    double area = 0.0;
    for (const Index p : run.pieces)
      area += before.pieces()[p].area;
    return area < 0.51;
  };
  Zip(cube.chains, 1e-3, {}, {}, is_small).run(state, none);
  EXPECT_EQ(state.piece_count(), 2U);
}

TEST(Zip, WithMoreStrainAllowedHasShorterSeams) {
  const SeamedCube cube;
  ThreadPool pool(2);
  double last = open_length(cube.mesh, cube.seams);
  for (const double limit : {0.001, 0.1, 0.2}) {
    SeamState state(cube.mesh, cube.seams, pool);
    Zip(cube.chains, limit, {}).run(state, OpenEdges(cube.seams.size(), 0));
    for (const PanelPiece& piece : state.pieces())
      EXPECT_LE(piece.strain(), limit);
    EXPECT_LT(open_length(cube.mesh, state.open()), last);
    last = open_length(cube.mesh, state.open());
  }
}

TEST(Unzip, KeepsTheLimit) {
  const SeamedCube cube;
  ThreadPool pool(2);
  SeamState state(cube.mesh, cube.seams, pool);
  Zip(cube.chains, 0.2, {}).run(state, OpenEdges(cube.seams.size(), 0));
  std::size_t piece = 0;
  while (state.pieces()[piece].triangles.empty())
    ++piece;
  ASSERT_GT(state.pieces()[piece].strain(), 0.05);
  const double before = open_length(cube.mesh, state.open());
  EXPECT_TRUE(unzip(state, cube.chains, piece, 0.05, 0.1));
  EXPECT_GT(open_length(cube.mesh, state.open()), before);
  for (const PanelPiece& part : state.pieces())
    EXPECT_LE(part.strain(), 0.05);
  // What it keeps of pieces is what they are.
  const SeamState anew(cube.mesh, state.open(), pool);
  EXPECT_EQ(anew.piece_count(), state.piece_count());
  EXPECT_EQ(anew.tips(), state.tips());
}

}  // namespace
}  // namespace planish
