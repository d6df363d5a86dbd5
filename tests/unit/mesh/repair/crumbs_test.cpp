#include <planish/mesh/inspect.h>
#include <planish/mesh/repair.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "unit/mesh/repair/repairs.h"

namespace planish {
namespace {

/// A sheet of area 400, then pieces of two triangles of some area each.
TriMesh with_pieces(std::size_t count, double area) {
  TriMesh mesh = meshes::flat_grid(20, 20);
  const TriMesh piece = scaled(meshes::flat_grid(1, 1), std::sqrt(area));
  for (std::size_t i = 0; i < count; ++i) {
    TriMesh apart = piece;
    for (Vec3& p : apart.positions)
      p += {30.0 + 10.0 * static_cast<double>(i), 0.0, 0.0};
    mesh = repairs::both(std::move(mesh), apart);
  }
  return mesh;
}

TEST(FindCrumbs, SmallPiecesBesideALargeOne) {
  for (const TriMesh& mesh : repairs::variants(with_pieces(5, 1.0))) {
    const Crumbs crumbs = find_crumbs(mesh);
    EXPECT_EQ(crumbs.pieces, 5U);
    EXPECT_EQ(crumbs.triangles.size(), 10U);
    EXPECT_NEAR(crumbs.area_share, 5.0 / 405.0, 1e-12);
    const RepairedMesh rest = without_triangles(mesh, crumbs.triangles);
    EXPECT_EQ(inspect(rest.mesh).topology.components, 1U);
    EXPECT_TRUE(repairs::has_sources(rest, mesh));
  }
}

TEST(FindCrumbs, PiecesOfAPercentAreNone) {
  EXPECT_EQ(find_crumbs(with_pieces(3, 5.0)).pieces, 0U);
  EXPECT_EQ(find_crumbs(meshes::flat_grid(4, 4)).pieces, 0U);
  EXPECT_EQ(find_crumbs({}).pieces, 0U);
}

TEST(FindCrumbs, WhereAllIsSmallNothingIsACrumb) {
  EXPECT_EQ(find_crumbs(with_pieces(60, 1.0)).pieces, 0U);
  EXPECT_EQ(find_crumbs(meshes::soup_of(meshes::flat_grid(12, 12))).pieces, 0U);
}

}  // namespace
}  // namespace planish
