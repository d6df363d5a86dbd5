#include <algorithm>

#include <planish/core/error.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/repair.h>
#include <planish/mesh/weld.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "unit/mesh/repair/repairs.h"

namespace planish {
namespace {

using repairs::variants;

TEST(RedundantTriangles, ASoundMeshStaysAsItIs) {
  for (const TriMesh& mesh :
       {meshes::rough_grid(6, 5, 1), meshes::tetrahedron(), meshes::torus(8, 9), TriMesh{}}) {
    const CleanedMesh clean = remove_redundant_triangles(mesh);
    EXPECT_EQ(clean.removed(), 0U);
    EXPECT_EQ(clean.mesh.triangles, mesh.triangles);
    EXPECT_TRUE(repairs::has_sources(clean, mesh));
  }
}

TEST(RedundantTriangles, CollapsedAndRepeatedOnesGo) {
  const TriMesh sound = meshes::rough_grid(6, 5, 2);
  TriMesh mesh = sound;
  mesh.triangles.insert(mesh.triangles.begin() + 3, Triangle{4, 4, 9});
  const Triangle t = mesh.triangles[10];
  mesh.triangles.push_back({t[1], t[2], t[0]});
  const CleanedMesh clean = remove_redundant_triangles(mesh);
  EXPECT_EQ(clean.collapsed, 1U);
  EXPECT_EQ(clean.repeated, 1U);
  EXPECT_EQ(clean.removed(), 2U);
  EXPECT_EQ(clean.mesh.triangles, sound.triangles);
  EXPECT_EQ(clean.source[3], 4U);
  EXPECT_TRUE(repairs::has_sources(clean, mesh));
}

TEST(RedundantTriangles, ATriangleOfThreeVerticesOnALineStays) {
  TriMesh mesh = meshes::flat_grid(4, 4);
  mesh.triangles.push_back({0, 1, 2});
  EXPECT_EQ(remove_redundant_triangles(mesh).removed(), 0U);
}

TEST(RedundantTriangles, AQuadrilateralIsThereByOneDiagonal) {
  const TriMesh sound = meshes::rough_grid(6, 5, 3);
  for (const std::size_t quad : {0U, 14U, 29U}) {
    TriMesh mesh = sound;
    const Triangle one = sound.triangles[2 * quad], other = sound.triangles[2 * quad + 1];
    mesh.triangles.push_back({one[1], one[2], other[2]});
    mesh.triangles.push_back({one[0], one[1], other[2]});
    for (const TriMesh& variant : variants(mesh)) {
      const CleanedMesh clean = remove_redundant_triangles(variant);
      EXPECT_EQ(clean.repeated, 2U);
      EXPECT_TRUE(repairs::is_disk(clean.mesh));
    }
  }
}

TEST(RedundantTriangles, OfADoubledSheetTheFirstSideStays) {
  const TriMesh sheet = meshes::rough_grid(6, 5, 4);
  TriMesh shared = sheet;
  for (const Triangle& t : turned_over(sheet).triangles)
    shared.triangles.push_back(t);
  for (const TriMesh& mesh : {shared, repairs::both(sheet, turned_over(sheet))}) {
    const CleanedMesh clean = remove_redundant_triangles(mesh);
    EXPECT_EQ(clean.backs, sheet.triangles.size());
    EXPECT_EQ(clean.mesh.triangles, sheet.triangles);
    for (const TriMesh& variant : variants(mesh)) {
      const CleanedMesh of_variant = remove_redundant_triangles(variant);
      EXPECT_EQ(of_variant.backs, sheet.triangles.size());
      EXPECT_TRUE(repairs::is_disk(of_variant.mesh));
    }
  }
}

/// It has its own border, which a doubled sheet has not.
TEST(RedundantTriangles, ASheetFoldedFlatOnItselfStays) {
  TriMesh sheet = meshes::flat_grid(8, 5);
  for (Vec3& p : sheet.positions)
    p.x = std::min(p.x, 8.0 - p.x);
  EXPECT_EQ(remove_redundant_triangles(sheet).removed(), 0U);
  for (const TriMesh& variant : variants(sheet))
    EXPECT_EQ(remove_redundant_triangles(variant).removed(), 0U);
}

/// Sides that alternate in the file are told apart by their orientation.
TEST(RedundantTriangles, OfADoubledSheetOneSideStaysInAnyOrder) {
  const TriMesh sheet = meshes::rough_grid(6, 5, 5);
  const TriMesh back = turned_over(sheet);
  TriMesh mesh = sheet;
  mesh.triangles.clear();
  for (std::size_t t = 0; t < sheet.triangles.size(); ++t) {
    mesh.triangles.push_back((t % 3 == 0 ? sheet : back).triangles[t]);
    mesh.triangles.push_back((t % 3 == 0 ? back : sheet).triangles[t]);
  }
  const CleanedMesh clean = remove_redundant_triangles(mesh);
  EXPECT_EQ(clean.mesh.triangles, sheet.triangles);
}

/// The quadrilaterals of a grid divided by their other diagonals.
TriMesh by_other_diagonals(TriMesh grid) {
  for (std::size_t t = 0; t < grid.triangles.size(); t += 2) {
    const Triangle one = grid.triangles[t], other = grid.triangles[t + 1];
    grid.triangles[t] = {one[0], one[1], other[2]};
    grid.triangles[t + 1] = {one[1], one[2], other[2]};
  }
  return grid;
}

/// Those of the first mesh and then those of the second, which has the same vertices.
TriMesh with_triangles_of(TriMesh mesh, const TriMesh& second) {
  mesh.triangles.insert(mesh.triangles.end(), second.triangles.begin(), second.triangles.end());
  return mesh;
}

TEST(RedundantTriangles, ADoubledSheetMayHaveOtherDiagonals) {
  // One row has diagonals only that could be those of quadrilaterals across the sheets.
  for (const TriMesh& sheet : {meshes::rough_grid(6, 5, 7), meshes::rough_grid(7, 1, 7)}) {
    const TriMesh other = by_other_diagonals(sheet), back = turned_over(other);
    const std::size_t count = sheet.triangles.size();
    for (const TriMesh& mesh : {with_triangles_of(sheet, back), repairs::both(sheet, back)}) {
      const CleanedMesh clean = remove_redundant_triangles(mesh);
      EXPECT_EQ(clean.backs, count);
      EXPECT_EQ(clean.mesh.triangles, sheet.triangles);
      for (const TriMesh& variant : variants(mesh)) {
        const CleanedMesh of_variant = remove_redundant_triangles(variant);
        EXPECT_EQ(of_variant.backs, count);
        EXPECT_TRUE(repairs::is_disk(of_variant.mesh));
      }
    }
    const CleanedMesh same_way = remove_redundant_triangles(repairs::both(sheet, other));
    EXPECT_EQ(same_way.repeated, count);
    EXPECT_EQ(same_way.mesh.triangles, sheet.triangles);
  }
}

TEST(RedundantTriangles, ACopyOfASheetGoesThoughItIsTheSameWayRound) {
  const TriMesh sheet = meshes::rough_grid(6, 5, 8);
  const TriMesh twice = repairs::both(repairs::both(sheet, sheet), turned_over(sheet));
  const CleanedMesh clean = remove_redundant_triangles(twice);
  EXPECT_EQ(clean.repeated, sheet.triangles.size());
  EXPECT_EQ(clean.backs, sheet.triangles.size());
  EXPECT_EQ(clean.mesh.triangles, sheet.triangles);
}

TEST(RedundantTriangles, ADoubledSheetMayBeBesideItselfByRounding) {
  const TriMesh sheet = meshes::rough_grid(6, 5, 9);
  const auto moved = [&](double length) {
    TriMesh mesh = sheet;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      mesh.positions[v].z += v % 3 == 0 ? -length : length;
    return mesh;
  };
  const double length = default_weld_length(sheet);
  for (const TriMesh& variant :
       variants(repairs::both(sheet, turned_over(by_other_diagonals(moved(0.5 * length))))))
    EXPECT_EQ(remove_redundant_triangles(variant).backs, sheet.triangles.size());
  EXPECT_EQ(remove_redundant_triangles(repairs::both(sheet, moved(0.9 * length))).repeated,
            sheet.triangles.size());
  EXPECT_EQ(remove_redundant_triangles(repairs::both(sheet, moved(1.2 * length))).removed(), 0U);
}

/// Half of a sheet may be a patch on it.
TEST(RedundantTriangles, ACopyOfAPartOfASheetStays) {
  const TriMesh sheet = meshes::rough_grid(6, 6, 10);
  TriMesh half = sheet;
  half.triangles.resize(half.triangles.size() / 2);
  EXPECT_EQ(remove_redundant_triangles(repairs::both(sheet, half)).removed(), 0U);
  EXPECT_EQ(remove_redundant_triangles(repairs::both(half, turned_over(sheet))).removed(), 0U);
  EXPECT_EQ(remove_redundant_triangles(with_triangles_of(sheet, turned_over(half))).removed(), 0U);
}

TEST(RedundantTriangles, OneOppositeTriangleIsAFault) {
  TriMesh mesh = meshes::rough_grid(6, 5, 6);
  const Triangle t = mesh.triangles[20];
  mesh.triangles.push_back({t[0], t[2], t[1]});
  EXPECT_EQ(remove_redundant_triangles(mesh).removed(), 0U);
  const TriMesh apart = repairs::both(meshes::rough_grid(6, 5, 6), {{}, {}});
  EXPECT_EQ(remove_redundant_triangles(apart).removed(), 0U);
}

/// A grid of 200 triangles with some that stand on inner edges.
TriMesh with_fins(std::size_t fins) {
  TriMesh mesh = meshes::flat_grid(10, 10);
  for (std::size_t i = 0; i < fins; ++i) {
    const Triangle t = mesh.triangles[2 * (33 + i)];
    mesh.positions.push_back(mesh.positions[t[0]] + Vec3{0.5, 0.5, 0.7});
    mesh.triangles.push_back({t[0], t[2], static_cast<Index>(mesh.positions.size() - 1)});
  }
  return mesh;
}

TEST(RedundantTriangles, FinsOnAWholeSurfaceGo) {
  for (const TriMesh& mesh : variants(with_fins(3))) {
    const CleanedMesh clean = remove_redundant_triangles(mesh);
    EXPECT_EQ(clean.fins, 3U);
    EXPECT_TRUE(repairs::is_disk(clean.mesh));
    EXPECT_EQ(clean.mesh.triangles.size(), 200U);
  }
}

TEST(RedundantTriangles, PanelsOfASharedEdgeAreNoFins) {
  TriMesh mesh = meshes::flat_grid(10, 10);
  const auto first = static_cast<Index>(mesh.positions.size());
  for (Index i = 0; i <= 10; ++i)
    mesh.positions.push_back({static_cast<double>(i), 5.0, 1.0});
  for (Index i = 0; i < 10; ++i) {
    const Index a = 55 + i;
    mesh.triangles.push_back({a, a + 1, first + i});
    mesh.triangles.push_back({a + 1, first + i + 1, first + i});
  }
  EXPECT_EQ(remove_redundant_triangles(mesh).removed(), 0U);
}

TEST(RedundantTriangles, EntriesThatCannotBeUsedAreRefused) {
  TriMesh mesh = meshes::flat_grid(2, 2);
  mesh.triangles[3][1] = 100;
  EXPECT_THROW(remove_redundant_triangles(mesh), Error);
  mesh = meshes::flat_grid(2, 2);
  mesh.positions[1].x = std::nan("");
  EXPECT_THROW(remove_redundant_triangles(mesh), Error);
}

}  // namespace
}  // namespace planish
