#include <algorithm>

#include <planish/mesh/inspect.h>
#include <planish/mesh/repair.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "unit/mesh/repair/repairs.h"

namespace planish {
namespace {

/// Without the quadrilaterals below and above the inner vertex v, which touch there.
TriMesh with_touching_holes(std::size_t columns, std::size_t rows, Index v) {
  TriMesh mesh = meshes::rough_grid(columns, rows, 7, 0.1, 0.1);
  std::erase_if(mesh.triangles, [v](const Triangle& t) {
    const auto [low, high] = std::minmax({t[0], t[1], t[2]});
    return low == v || high == v;
  });
  return mesh;
}

TEST(SeparateTouching, SoundMeshesStay) {
  const TriMesh mesh = meshes::rough_grid(5, 4, 1);
  const SeparatedMesh separated = separate_touching(mesh);
  EXPECT_EQ(separated.places, 0U);
  EXPECT_EQ(separated.mesh.triangles, mesh.triangles);
}

TEST(SeparateTouching, HolesThatTouchAreToldApartAndClosed) {
  const TriMesh mesh = with_touching_holes(8, 8, 40);
  ASSERT_TRUE(blocking_problem(inspect(mesh), Purpose::measure));
  for (const TriMesh& variant : repairs::variants(mesh)) {
    const SeparatedMesh separated = separate_touching(variant);
    EXPECT_EQ(separated.places, 1U);
    EXPECT_TRUE(repairs::has_sources(separated, variant));
    EXPECT_EQ(separated.mesh.positions.size(), variant.positions.size() + 1);
    EXPECT_EQ(separated.vertex_source.back(), 40U);
    EXPECT_FALSE(blocking_problem(inspect(separated.mesh), Purpose::measure));
    EXPECT_EQ(repairs::area(separated.mesh), repairs::area(variant));
    const FilledMesh filled = fill_holes(separated.mesh, 1e9);
    EXPECT_EQ(filled.filled, 2U);
    EXPECT_EQ(filled.left, 0U);
    EXPECT_TRUE(repairs::is_disk(filled.mesh));
  }
}

TEST(SeparateTouching, PiecesThatTouchAtAPointComeApart) {
  TriMesh mesh = repairs::both(meshes::flat_grid(3, 3), meshes::flat_grid(3, 3));
  for (std::size_t v = 16; v < 32; ++v)
    mesh.positions[v] += {3.0, 3.0, 0.0};
  for (Triangle& t : mesh.triangles) {
    for (Index& v : t)
      v = v == 16 ? 15 : v;
  }
  const SeparatedMesh separated = separate_touching(mesh);
  EXPECT_EQ(separated.places, 1U);
  EXPECT_EQ(inspect(separated.mesh).topology.components, 2U);
}

/// Three half planes on one axis, each of n by n cells.
TriMesh three_sheets(std::size_t n) {
  TriMesh mesh = meshes::flat_grid(n, n);
  const TriMesh flat = mesh;
  for (int k = 1; k < 3; ++k) {
    TriMesh sheet = flat;
    for (Vec3& p : sheet.positions)
      p = k == 1 ? Vec3{-0.5 * p.x, p.y, p.x} : Vec3{-0.5 * p.x, p.y, -p.x};
    const auto shift = static_cast<Index>(mesh.positions.size());
    mesh = repairs::both(std::move(mesh), k == 1 ? turned_over(sheet) : sheet);
    for (Triangle& t : mesh.triangles) {
      for (Index& v : t)
        v = v >= shift && (v - shift) % (n + 1) == 0 ? v - shift : v;
    }
  }
  return mesh;
}

TEST(DivideAtNonmanifoldEdges, SheetsBecomePieces) {
  const TriMesh mesh = three_sheets(5);
  for (const TriMesh& variant : repairs::variants(mesh)) {
    const SeparatedMesh divided = divide_at_nonmanifold_edges(variant);
    EXPECT_EQ(divided.places, 5U);
    EXPECT_TRUE(repairs::has_sources(divided, variant));
    const Inspection found = inspect(divided.mesh);
    EXPECT_FALSE(blocking_problem(found, Purpose::evolve));
    EXPECT_EQ(found.topology.components, 3U);
    EXPECT_EQ(found.topology.border_loops, 3U);
    EXPECT_EQ(repairs::area(divided.mesh), repairs::area(variant));
  }
}

TEST(DivideAtNonmanifoldEdges, AFinLeavesItsSurfaceWhole) {
  TriMesh mesh = meshes::flat_grid(6, 6);
  mesh.positions.push_back({2.5, 2.5, 1.0});
  mesh.triangles.push_back({16, 24, 49});
  const SeparatedMesh divided = divide_at_nonmanifold_edges(mesh);
  const Inspection found = inspect(divided.mesh);
  EXPECT_EQ(divided.places, 1U);
  EXPECT_EQ(found.topology.components, 2U);
  EXPECT_EQ(found.topology.border_loops, 2U);
}

}  // namespace
}  // namespace planish
