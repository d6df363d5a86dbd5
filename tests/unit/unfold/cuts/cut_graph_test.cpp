#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include <planish/core/error.h>
#include <planish/mesh/inspect.h>
#include <planish/unfold/suggest_cuts.h>

#include <gtest/gtest.h>

#include "mesh/split.h"
#include "support/meshes.h"
#include "support/solids.h"
#include "unfold/cuts/reduced_paths.h"

namespace planish {
namespace {

constexpr double pi = std::numbers::pi;

/// The surface stays, vertices keep their numbers, and every part is a disk.
void expect_disks(const TriMesh& mesh, const CutGraph& graph, std::size_t parts = 1) {
  ASSERT_EQ(graph.source.size(), graph.mesh.positions.size());
  for (std::size_t v = 0; v < graph.source.size(); ++v) {
    if (v < mesh.positions.size()) {
      EXPECT_EQ(graph.source[v], v);
    }
    if (graph.source[v] != CutGraph::none) {
      EXPECT_EQ(graph.mesh.positions[v], mesh.positions[graph.source[v]]);
    }
  }
  EXPECT_NEAR(meshes::area(graph.mesh), meshes::area(mesh), 1e-12 * meshes::area(mesh));
  const std::vector<NamedPatch> pieces = split(graph.mesh, "piece");
  EXPECT_EQ(pieces.size(), parts);
  for (const NamedPatch& piece : pieces) {
    const Topology topology = inspect(piece.mesh).topology;
    EXPECT_EQ(topology.euler_characteristic, 1);
    EXPECT_EQ(topology.border_loops, 1U);
  }
}

/// A closed surface around cubes at these places of a grid, each square four triangles.
TriMesh around_cubes(const std::set<std::array<int, 3>>& cubes) {
  TriMesh mesh;
  std::map<std::array<int, 3>, Index> numbers;  // of places twice as fine
  const auto number = [&](std::array<int, 3> at) {
    const auto [found, is_new] = numbers.try_emplace(at, static_cast<Index>(mesh.positions.size()));
    if (is_new) mesh.positions.push_back({0.5 * at[0], 0.5 * at[1], 0.5 * at[2]});
    return found->second;
  };
  for (const auto& cube : cubes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {0, 1}) {
        std::array<int, 3> beyond = cube;
        beyond[axis] += side == 0 ? -1 : 1;
        if (cubes.contains(beyond)) continue;
        std::array<std::array<int, 3>, 4> corners{};
        for (std::size_t k = 0; k < 4; ++k) {
          corners[k] = {2 * cube[0], 2 * cube[1], 2 * cube[2]};
          corners[k][axis] += 2 * side;
          const std::size_t one = (axis + 1) % 3, other = (axis + 2) % 3;
          corners[k][side == 1 ? one : other] += k == 1 || k == 2 ? 2 : 0;
          corners[k][side == 1 ? other : one] += k >= 2 ? 2 : 0;
        }
        std::array<int, 3> middle = {2 * cube[0] + 1, 2 * cube[1] + 1, 2 * cube[2] + 1};
        middle[axis] = 2 * cube[axis] + 2 * side;
        for (std::size_t k = 0; k < 4; ++k)
          mesh.triangles.push_back(
              {number(middle), number(corners[k]), number(corners[(k + 1) % 4])});
      }
    }
  }
  return mesh;
}

/// A plate of cubes with two holes: a double torus.
TriMesh double_torus() {
  std::set<std::array<int, 3>> cubes;
  for (int x = 0; x < 5; ++x) {
    for (int y = 0; y < 3; ++y) {
      if (y != 1 || x % 2 == 0) cubes.insert({x, y, 0});
    }
  }
  return around_cubes(cubes);
}

TEST(CutGraph, LeavesADiskAsItIs) {
  const TriMesh grid = meshes::rough_grid(5, 4, 1);
  const CutGraph graph = cut_graph(Patch(grid));
  EXPECT_EQ(graph.lines, 0U);
  EXPECT_EQ(graph.length, 0.0);
  EXPECT_EQ(graph.mesh.triangles, grid.triangles);
}

TEST(CutGraph, OpensATorusAlongItsShortestLoops) {
  const TriMesh torus = meshes::torus(24, 48);
  double farthest = 0.0, highest = 0.0, nearest = HUGE_VAL;
  for (const Vec3 p : torus.positions) {
    farthest = std::max(farthest, std::hypot(p.x, p.y));
    nearest = std::min(nearest, std::hypot(p.x, p.y));
    highest = std::max(highest, std::abs(p.z));
  }
  const double inner = 2.0 * pi * nearest, tube = 2.0 * pi * highest;
  ASSERT_NEAR(farthest - nearest, 2.0 * highest, 1e-3);
  const CutGraph graph = cut_graph(Patch(torus));
  expect_disks(torus, graph);
  EXPECT_EQ(graph.lines, 2U);
  EXPECT_NEAR(graph.length, inner + tube, 0.02 * (inner + tube));
  const CutGraph along = cut_graph(Patch(torus), {.along_edges = true});
  expect_disks(torus, along);
  EXPECT_EQ(along.mesh.triangles.size(), torus.triangles.size());
  EXPECT_EQ(along.paths.size(), along.lines);
  EXPECT_GE(along.length, graph.length * (1.0 - 1e-9));
}

TEST(CutGraph, OpensEveryHandle) {
  const TriMesh mesh = double_torus();
  ASSERT_EQ(inspect(mesh).topology.genus, 2U);
  for (const bool relieve : {false, true}) {
    const CutGraph graph = cut_graph(Patch(mesh), {.relieve = relieve});
    expect_disks(mesh, graph);
    EXPECT_EQ(unfold(Patch(graph.mesh)).flipped_triangles, 0U);
  }
}

TEST(CutGraph, OpensATubeStraight) {
  const TriMesh tube = meshes::tube(12, 5);
  const CutGraph graph = cut_graph(Patch(tube));
  expect_disks(tube, graph);
  EXPECT_EQ(graph.lines, 1U);
  EXPECT_NEAR(graph.length, 5.0, 1e-12);
}

TEST(CutGraph, OpensASphereFromPoleToPole) {
  const TriMesh sphere = solids::sphere(1.0, 12);
  const CutGraph graph = cut_graph(Patch(sphere));
  expect_disks(sphere, graph);
  EXPECT_EQ(graph.lines, 1U);
  EXPECT_GT(graph.length, 0.8 * pi);
  EXPECT_LE(graph.length, pi);
}

TEST(CutGraph, JoinsThreeBordersOrKeepsHoles) {
  const TriMesh mesh = meshes::plate_with_two_holes();
  ASSERT_EQ(inspect(mesh).topology.border_loops, 3U);
  const CutGraph disk = cut_graph(Patch(mesh));
  expect_disks(mesh, disk);
  EXPECT_NEAR(disk.length, 4.0, 1e-12);
  const CutGraph holes = cut_graph(Patch(mesh), {.keep_holes = true});
  EXPECT_EQ(holes.lines, 0U);
  EXPECT_EQ(inspect(holes.mesh).topology.border_loops, 3U);
}

TEST(CutGraph, OpensATubeWithAHoleInItsSideOnce) {
  TriMesh tube = meshes::tube(24, 9);
  const Index v = 24 * 4 + 3;
  std::erase_if(tube.triangles,
                [&](const Triangle& t) { return std::find(t.begin(), t.end(), v) != t.end(); });
  ASSERT_EQ(inspect(tube).topology.border_loops, 3U);
  const CutGraph graph = cut_graph(Patch(tube), {.keep_holes = true});
  EXPECT_EQ(graph.lines, 1U);
  EXPECT_NEAR(graph.length, 9.0, 1e-12);
  EXPECT_EQ(inspect(graph.mesh).topology.border_loops, 2U);
  EXPECT_EQ(inspect(graph.mesh).topology.genus, 0U);
}

TEST(CutGraph, OpensEachPartOnItsOwn) {
  const TriMesh mesh = meshes::side_by_side(
      meshes::side_by_side(meshes::torus(8, 16), meshes::flat_grid(3, 2)), meshes::tube(8, 3));
  expect_disks(mesh, cut_graph(Patch(mesh)), 3);
}

TEST(CutGraph, GoesRoundPlacesThatWeighMore) {
  const TriMesh tube = meshes::tube(24, 6);
  std::vector<double> weights;
  for (const Vec3 p : tube.positions)
    weights.push_back(p.y > -0.5 ? 20.0 : 1.0);
  const CutGraph graph = cut_graph(Patch(tube), {.weights = weights});
  expect_disks(tube, graph);
  for (std::size_t v = tube.positions.size(); v < graph.mesh.positions.size(); ++v)
    EXPECT_LT(graph.mesh.positions[v].y, -0.5);
  EXPECT_THROW(cut_graph(Patch(tube), {.weights = {1.0}}), Error);
}

TEST(CutGraph, MakesANetOfABox) {
  std::set<std::array<int, 3>> cubes;
  for (int x = 0; x < 4; ++x) {
    for (int y = 0; y < 3; ++y)
      cubes.insert({x, y, 0});
  }
  const TriMesh box = around_cubes(cubes);
  const CutGraph graph = cut_graph(Patch(box), {.relieve = true});
  expect_disks(box, graph);
  // Five of the twelve edges stay whole: three of the longest, which four faces hang together by,
  // and one for either end.
  const double edges = 4 * 4.0 + 4 * 3.0 + 4 * 1.0;
  EXPECT_NEAR(graph.length, edges - (3 * 4.0 + 2 * 3.0), 1e-12);
  const Patch patch(graph.mesh);
  const Pattern pattern = unfold(patch);
  EXPECT_FALSE(pattern.overlaps);
  EXPECT_LT(edge_strain(patch, pattern.positions).max, 1e-9);
}

/// A flat ring that goes round one and a half times, the second time above the first.
TriMesh winding_strip() {
  TriMesh strip = meshes::flat_grid(60, 4);
  for (Vec3& p : strip.positions) {
    const double turn = 3.0 * pi * p.x / 60.0, radius = 2.0 + 0.5 * p.y;
    p = {radius * std::cos(turn), radius * std::sin(turn), 0.01 * p.x};
  }
  return strip;
}

TEST(CutGraph, DividesWhatWouldOverlap) {
  const TriMesh strip = winding_strip();
  EXPECT_TRUE(unfold(Patch(strip)).overlaps);
  EXPECT_EQ(cut_graph(Patch(strip)).lines, 0U);
  const CutGraph graph = cut_graph(Patch(strip), {.most_pieces = 8});
  EXPECT_EQ(graph.lines, 1U);
  EXPECT_NEAR(graph.length, 2.0, 1e-3) << "straight across";
  expect_disks(strip, graph, 2);
  for (const NamedPatch& piece : split(graph.mesh, "piece"))
    EXPECT_FALSE(unfold(Patch(piece.mesh)).overlaps);
}

TEST(CutGraph, RefusesABandOfOneSide) {
  EXPECT_EQ(inspect(meshes::moebius(12)).problems.front().code, ErrorCode::non_orientable);
  EXPECT_THROW(cut_graph(Patch(meshes::moebius(12))), Error);
}

TEST(ReducedPaths, LeaveOutWhatDivides) {
  const Patch grid(meshes::flat_grid(4, 4));  // five vertices a row
  const Chains across = {{10, 11, 12, 13, 14}};
  EXPECT_TRUE(reduced_paths(grid, across, true).empty());
  const Chains dart = {{10, 11, 12}};
  EXPECT_EQ(reduced_paths(grid, dart, true), dart);
  EXPECT_TRUE(reduced_paths(grid, dart, false).empty());
  EXPECT_TRUE(reduced_paths(grid, Chains{{0, 1, 2}}, true).empty()) << "along the border";
}

}  // namespace
}  // namespace planish
