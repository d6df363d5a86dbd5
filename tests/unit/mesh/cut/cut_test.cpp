#include <algorithm>
#include <cstring>
#include <functional>

#include <planish/mesh/cut.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/seams.h>
#include <planish/mesh/shapes.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

#include <gtest/gtest.h>

#include "mesh/split.h"
#include "support/meshes.h"
#include "support/ringed_disk.h"

namespace planish {
namespace {

using Indices = std::vector<Index>;

std::vector<CutPath> paths_of(const std::vector<Indices>& lines) {
  std::vector<CutPath> paths;
  for (const Indices& line : lines)
    paths.push_back({line});
  return paths;
}

CutMesh cut(const TriMesh& mesh, const std::vector<Indices>& lines) {
  return cut_open(Patch(mesh), paths_of(lines));
}

bool is_disk(const TriMesh& mesh) {
  return !blocking_problem(inspect(mesh), Purpose::unfold);
}

/// What holds of every cut.
void expect_sound(const CutMesh& cut, const TriMesh& mesh) {
  ASSERT_EQ(cut.source.size(), cut.mesh.positions.size());
  ASSERT_EQ(cut.mesh.triangles.size(), mesh.triangles.size());
  EXPECT_FALSE(blocking_problem(inspect(cut.mesh), Purpose::measure));
  for (std::size_t v = 0; v < cut.source.size(); ++v) {
    if (v < mesh.positions.size()) {
      EXPECT_EQ(cut.source[v], v);
    } else {
      EXPECT_LT(cut.source[v], mesh.positions.size());
    }
    EXPECT_EQ(std::memcmp(&cut.mesh.positions[v], &mesh.positions[cut.source[v]], sizeof(Vec3)), 0);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(cut.source[cut.mesh.triangles[t][i]], mesh.triangles[t][i]);
  }
}

/// The grid of a closed box of six squares of n x n cells.
TriMesh closed_box(std::size_t n) {
  TriMesh mesh;
  const auto vertex = [&](std::array<std::size_t, 3> at) {
    const Vec3 p = {static_cast<double>(at[0]), static_cast<double>(at[1]),
                    static_cast<double>(at[2])};
    const auto found = std::find(mesh.positions.begin(), mesh.positions.end(), p);
    if (found != mesh.positions.end()) return static_cast<Index>(found - mesh.positions.begin());
    mesh.positions.push_back(p);
    return static_cast<Index>(mesh.positions.size() - 1);
  };
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t side = 0; side < 2; ++side) {
      for (std::size_t i = 0; i < n * n; ++i) {
        const auto corner = [&](std::size_t a, std::size_t b) {
          std::array<std::size_t, 3> at{};
          at[axis] = side * n;
          at[(axis + 1) % 3] = i % n + a;
          at[(axis + 2) % 3] = i / n + b;
          return vertex(at);
        };
        const Index p = corner(0, 0), q = corner(1, 0), r = corner(1, 1), s = corner(0, 1);
        if (side == 1) {
          mesh.triangles.push_back({p, q, r});
          mesh.triangles.push_back({p, r, s});
        } else {
          mesh.triangles.push_back({p, r, q});
          mesh.triangles.push_back({p, s, r});
        }
      }
    }
  }
  return mesh;
}

/// A cone of apex angle sum 2 pi * 0.8 as rings of `around` vertices around vertex 0.
TriMesh ringed_cone(std::size_t around, std::size_t rings) {
  return meshes::ringed_disk(around, rings, [](double r, double) { return -0.75 * r; });
}

TEST(Cut, OpensATubeToADisk) {
  const TriMesh tube = meshes::tube(12, 5);
  const CutMesh open = cut(tube, {{3, 63}});  // from rim to rim, shortest way
  expect_sound(open, tube);
  EXPECT_TRUE(is_disk(open.mesh));
  EXPECT_EQ(inspect(open.mesh).topology.euler_characteristic, 1);
  EXPECT_EQ(inspect(tube).topology.euler_characteristic, 0);
  EXPECT_EQ(open.edges, 5U);
  EXPECT_EQ(open.length, 5.0);
  EXPECT_EQ(open.paths.front(), (Indices{3, 15, 27, 39, 51, 63}));
  EXPECT_EQ(open.source.size(), tube.positions.size() + 6);
  EXPECT_TRUE(std::equal(open.paths.front().begin(), open.paths.front().end(),
                         open.source.end() - 6));  // copies by what they are copies of
}

TEST(Cut, OfADartToTheApexLetsAConeLieFlat) {
  const TriMesh cone = ringed_cone(16, 6);
  const auto strain = [](const TriMesh& mesh) {
    const Patch patch(mesh);
    return edge_strain(patch, unfold(patch).positions);
  };
  EXPECT_GT(strain(cone).max, 0.01);
  const CutMesh dart = cut(cone, {{0, 1 + 5 * 16}});
  expect_sound(dart, cone);
  EXPECT_TRUE(is_disk(dart.mesh));
  EXPECT_EQ(dart.edges, 6U);
  EXPECT_LT(strain(dart.mesh).max, 1e-9);
  const std::vector<TriMesh> one = {dart.mesh};
  const auto seams = find_seams(one);
  ASSERT_EQ(seams.size(), 1U);
  EXPECT_EQ(seams[0].sides[0].vertices.size(), 7U);
}

TEST(Cut, LowersTheStrainOfADome) {
  const TriMesh dome = make_shape("dome", 600);
  const auto rms = [](const TriMesh& mesh) {
    const Patch patch(mesh);
    return edge_strain(patch, unfold(patch).positions).rms;
  };
  const Patch surface(dome);
  const Vec3 top = *std::max_element(dome.positions.begin(), dome.positions.end(),
                                     [](Vec3 a, Vec3 b) { return a.z < b.z; });
  const auto apex = static_cast<Index>(
      std::find(dome.positions.begin(), dome.positions.end(), top) - dome.positions.begin());
  const CutMesh dart = cut(dome, {{surface.border_loops().front()[5], apex}});
  expect_sound(dart, dome);
  EXPECT_LT(rms(dart.mesh), 0.8 * rms(dome));
}

TEST(Cut, OfAClosedSurfaceAlongALineMakesADisk) {
  const TriMesh box = closed_box(4);
  EXPECT_EQ(inspect(box).topology.euler_characteristic, 2);
  const CutMesh open = cut(box, {{0, static_cast<Index>(box.positions.size() - 1)}});
  expect_sound(open, box);
  EXPECT_TRUE(is_disk(open.mesh));
}

TEST(Cut, OfABoxAlongSevenEdgesLaysItOutFlat) {
  const TriMesh box = closed_box(3);
  const auto corner = [&](double x, double y, double z) {
    const Vec3 p = {3.0 * x, 3.0 * y, 3.0 * z};
    return static_cast<Index>(std::find(box.positions.begin(), box.positions.end(), p) -
                              box.positions.begin());
  };
  // The four upright edges, and three of the lid.
  const CutMesh net =
      cut(box, {{corner(0, 0, 0), corner(0, 0, 1)},
                {corner(1, 0, 0), corner(1, 0, 1)},
                {corner(1, 1, 0), corner(1, 1, 1)},
                {corner(0, 1, 0), corner(0, 1, 1)},
                {corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1)}});
  expect_sound(net, box);
  ASSERT_TRUE(is_disk(net.mesh));
  EXPECT_EQ(net.edges, 21U);
  const Patch patch(net.mesh);
  const Pattern flat = unfold(patch);
  EXPECT_LT(edge_strain(patch, flat.positions).max, 1e-9);
  EXPECT_FALSE(flat.overlaps);
}

TEST(Cut, FromBorderToBorderGivesTwoPiecesWithEqualSeams) {
  const TriMesh mesh = meshes::rough_grid(9, 6, 5);
  const CutMesh halves = cut(mesh, {{4, 24, 65}});
  expect_sound(halves, mesh);
  const auto pieces = split(halves.mesh, "grid");
  ASSERT_EQ(pieces.size(), 2U);
  std::vector<TriMesh> patches;
  for (const NamedPatch& piece : pieces) {
    EXPECT_TRUE(is_disk(piece.mesh));
    patches.push_back(piece.mesh);
  }
  const auto seams = find_seams(patches);
  ASSERT_EQ(seams.size(), 1U);
  EXPECT_EQ(seams[0].sides[0].vertices.size(), halves.edges + 1);
  const double length = length_of(seams[0].sides[0], patches[seams[0].sides[0].patch].positions);
  EXPECT_EQ(length, length_of(seams[0].sides[1], patches[seams[0].sides[1].patch].positions));
  EXPECT_NEAR(length, halves.length, 1e-12);
}

TEST(Cut, MayBranchCrossAndShareEdges) {
  const TriMesh grid = meshes::flat_grid(6, 6);  // number 7 y + x at (x, y)
  // A stem from below with two branches, the second path repeating the stem.
  const CutMesh fork = cut(grid, {{3, 10, 17, 16, 15}, {3, 10, 17, 18, 19}});
  expect_sound(fork, grid);
  EXPECT_TRUE(is_disk(fork.mesh));
  EXPECT_EQ(fork.edges, 6U);
  EXPECT_EQ(std::count(fork.source.begin(), fork.source.end(), 17), 3);
  EXPECT_EQ(std::count(fork.source.begin(), fork.source.end(), 10), 2);
  EXPECT_EQ(std::count(fork.source.begin(), fork.source.end(), 15), 1);
  // A cross from side to side: four pieces.
  const CutMesh cross = cut(grid, {{3, 10, 17, 24, 31, 38, 45}, {21, 22, 23, 24, 25, 26, 27}});
  expect_sound(cross, grid);
  EXPECT_EQ(split(cross.mesh, "quarter").size(), 4U);
  EXPECT_EQ(std::count(cross.source.begin(), cross.source.end(), 24), 4);
  // Hanging on another cut, not on the border.
  EXPECT_TRUE(is_disk(cut(grid, {{3, 10, 17}, {17, 16, 15}}).mesh));
}

TEST(Cut, DependsOnlyOnTheEdgesThatAreCut) {
  const TriMesh grid = meshes::rough_grid(6, 6, 2);
  const CutMesh a = cut(grid, {{3, 10, 17, 16, 15}, {17, 18, 19}});
  const CutMesh b = cut(grid, {{19, 18, 17, 10, 3}, {15, 15, 16, 17, 17}});
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
  EXPECT_EQ(a.source, b.source);
  const CutMesh none = cut(grid, {});
  EXPECT_EQ(none.mesh.triangles, grid.triangles);
  EXPECT_EQ(none.source.size(), grid.positions.size());
}

TEST(Cut, KeepsOffTheBorderWhereItFindsItsOwnWay) {
  const TriMesh grid = meshes::flat_grid(6, 4);
  // Along the lower side would be shortest.
  const CutMesh bow = cut(grid, {{1, 5}});
  expect_sound(bow, grid);
  for (std::size_t i = 1; i + 1 < bow.paths.front().size(); ++i)
    EXPECT_FALSE(Patch(grid).is_border(bow.paths.front()[i]));
  EXPECT_EQ(split(bow.mesh, "piece").size(), 2U);
}

TEST(Cut, HasALengthAtAnySize) {
  for (const double size : {1e-200, 1e200}) {
    TriMesh tube = meshes::tube(12, 5);
    for (Vec3& p : tube.positions)
      p = size * p;
    EXPECT_NEAR(cut(tube, {{3, 63}}).length / size, 5.0, 1e-12);
  }
}

void expect_misplaced(const TriMesh& mesh, const std::vector<CutPath>& paths, ErrorCode code,
                      const std::string& part) {
  try {
    cut_open(Patch(mesh), paths);
    FAIL() << "no error: " << part;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_NE(error.message().find(part), std::string::npos) << error.what();
    EXPECT_EQ(error.place().line, paths.back().place.line);
  }
}

TEST(Cut, RefusesWhatOpensNothing) {
  const TriMesh grid = meshes::flat_grid(6, 6);
  const auto refused = [&](const Indices& line, const std::string& part,
                           ErrorCode code = ErrorCode::misplaced_cut) {
    expect_misplaced(grid, {{{3, 10}}, {line, {.path = "cuts.txt", .line = 7}}}, code, part);
  };
  refused({}, "cut 2 has no vertices");
  refused({8, 8}, "cut 2 has one vertex only, vertex 8 at (1, 1, 0)");
  refused({3, 49}, "cut 2 names vertex 49: the mesh has 49", ErrorCode::index_out_of_range);
  refused({8, 1, 2}, "cut 2 runs along the border from vertex 1 at (1, 0, 0) to vertex 2");
  refused({15, 16, 17}, "cut 2 from vertex 15 at (1, 2, 0) to vertex 17 at (3, 2, 0) never meets");
  refused({24, 25, 33}, "would only open a hole");
  TriMesh loose = grid;
  loose.positions.push_back({1, 2, 3});
  expect_misplaced(loose, {{{3, 49}}}, ErrorCode::misplaced_cut, "which no triangle uses");
  const TriMesh two = meshes::side_by_side(grid, meshes::tetrahedron());
  expect_misplaced(two, {{{3, 49}}}, ErrorCode::misplaced_cut, "finds no way inside the mesh");
  expect_misplaced(two, {{{3, 10}}, {{49, 50}}}, ErrorCode::misplaced_cut, "is the single edge");
  EXPECT_NO_THROW(cut(two, {{3, 10}, {49, 50, 51}}));
}

TEST(Cut, AlongALoopInsideTakesAPieceOut) {
  const TriMesh grid = meshes::flat_grid(6, 6);
  const CutMesh opened = cut(grid, {{24, 25, 33, 24}});
  const Topology topology = inspect(opened.mesh).topology;
  EXPECT_EQ(topology.components, 2U);
  EXPECT_EQ(topology.border_loops, 3U);
}

TEST(Cut, OfRandomPathsIsSound) {
  const TriMesh grid = meshes::rough_grid(12, 12, 3);
  const Patch patch(grid);
  Indices rim = patch.border_loops().front();
  // No cut can begin at the corner of a single triangle.
  std::erase_if(rim, [&](Index v) { return patch.ring(v).size() < 3; });
  meshes::Random random(5);
  const auto pick = [&](std::size_t count) {
    return static_cast<std::size_t>(0.4999999 * (random.number() + 1.0) *
                                    static_cast<double>(count));
  };
  for (int round = 0; round < 100; ++round) {
    std::vector<Indices> lines;
    for (std::size_t k = 0; k <= pick(4); ++k) {
      const Index inner = patch.inner_vertices()[pick(patch.inner_vertices().size())];
      lines.push_back({rim[pick(rim.size())], inner});
      if (pick(2) == 0) lines.back().push_back(patch.inner_vertices()[pick(100)]);
    }
    const CutMesh open = cut(grid, lines);
    expect_sound(open, grid);
    // Every piece has no handle and one border.
    for (const NamedPatch& piece : split(open.mesh, "piece"))
      EXPECT_TRUE(is_disk(piece.mesh));
  }
}

}  // namespace
}  // namespace planish
