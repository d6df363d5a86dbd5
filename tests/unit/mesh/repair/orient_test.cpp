#include <algorithm>
#include <array>

#include <planish/mesh/inspect.h>
#include <planish/mesh/repair.h>
#include <planish/mesh/seams.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh/split.h"
#include "support/jacket.h"
#include "support/meshes.h"
#include "unit/mesh/repair/repairs.h"

namespace planish {
namespace {

TEST(OrientConsistently, TheMinorityIsTurned) {
  const TriMesh sound = meshes::rough_grid(6, 5, 1);
  for (const TriMesh& right : repairs::variants(sound)) {
    TriMesh mesh = right;
    for (const std::size_t t : {0U, 17U, 18U, 40U})
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    const OrientedMesh oriented = orient_consistently(mesh);
    EXPECT_EQ(oriented.turned, 4U);
    EXPECT_EQ(oriented.mesh.triangles, right.triangles);
    EXPECT_TRUE(repairs::has_sources(oriented, mesh));
  }
}

TEST(OrientConsistently, EachPieceByItself) {
  const TriMesh grid = meshes::flat_grid(3, 3);
  TriMesh mesh = repairs::both(grid, turned_over(grid));
  std::swap(mesh.triangles[0][1], mesh.triangles[0][2]);
  std::swap(mesh.triangles[20][1], mesh.triangles[20][2]);
  const OrientedMesh oriented = orient_consistently(mesh);
  EXPECT_EQ(oriented.turned, 2U);
  EXPECT_EQ(oriented.mesh.triangles, repairs::both(grid, turned_over(grid)).triangles);
}

TEST(OrientConsistently, InATieTheFirstTriangleStays) {
  TriMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 3, 2}}};
  const OrientedMesh oriented = orient_consistently(mesh);
  EXPECT_EQ(oriented.turned, 1U);
  EXPECT_EQ(oriented.mesh.triangles[0], mesh.triangles[0]);
}

TEST(OrientConsistently, AMoebiusStripStays) {
  TriMesh mesh;
  for (Index i = 0; i < 9; ++i) {
    mesh.positions.push_back({std::cos(0.7 * i), std::sin(0.7 * i), 0.0});
    mesh.positions.push_back({2.0 * std::cos(0.7 * i), 2.0 * std::sin(0.7 * i), 0.0});
    const Index a = 2 * i, b = a + 1, c = i == 8 ? 1 : a + 2, d = i == 8 ? 0 : a + 3;
    mesh.triangles.push_back({a, b, d});
    mesh.triangles.push_back({a, d, c});
  }
  ASSERT_EQ(blocking_problem(inspect(mesh), Purpose::measure)->code, ErrorCode::non_orientable);
  const OrientedMesh oriented = orient_consistently(mesh);
  EXPECT_EQ(oriented.turned, 0U);
  EXPECT_EQ(oriented.mesh.triangles, mesh.triangles);
}

TEST(OrientConsistently, TrianglesThatNameAVertexTwiceDoNotCount) {
  TriMesh mesh = meshes::flat_grid(2, 2);
  mesh.triangles.push_back({4, 4, 0});
  mesh.triangles.push_back({4, 4, 8});
  EXPECT_EQ(orient_consistently(mesh).turned, 0U);
}

TEST(TurnedOver, TwiceIsTheMeshItself) {
  const TriMesh mesh = meshes::rough_grid(3, 4, 1);
  EXPECT_NE(turned_over(mesh).triangles, mesh.triangles);
  EXPECT_EQ(turned_over(turned_over(mesh)).triangles, mesh.triangles);
}

/// Its sleeves are meshed with their inner sides outside; here they are right.
std::vector<TriMesh> jacket() {
  std::vector<TriMesh> pieces;
  for (const NamedPatch& panel : meshes::Jacket::panels())
    pieces.push_back(panel.name.starts_with("sleeve") ? turned_over(panel.mesh) : panel.mesh);
  return pieces;
}

std::vector<std::size_t> inside_out_of(const std::vector<TriMesh>& pieces) {
  return find_inside_out(pieces, find_seams(pieces, 0.5));
}

TEST(FindInsideOut, NoneOfAProductThatFits) {
  EXPECT_THAT(inside_out_of(jacket()), testing::ElementsAre());
}

TEST(FindInsideOut, EachPieceThatWasTurned) {
  const std::vector<TriMesh> right = jacket();
  for (std::size_t p = 0; p < right.size(); ++p) {
    std::vector<TriMesh> pieces = right;
    pieces[p] = turned_over(pieces[p]);
    const std::vector<std::size_t> found = inside_out_of(pieces);
    // Of a piece that holds most of the area all others are turned to fit it.
    for (const std::size_t turned : found)
      pieces[turned] = turned_over(pieces[turned]);
    EXPECT_FALSE(found.empty());
    EXPECT_TRUE(inside_out_of(pieces).empty());
  }
}

TEST(FindInsideOut, TheSmallerAreaIsTurned) {
  TriMesh large = meshes::flat_grid(6, 5), small = meshes::flat_grid(2, 5);
  for (Vec3& p : small.positions)
    p.x += 6.0;
  for (const double scale : {1e-3, 1.0, 1e3}) {
    const TriMesh one = scaled(large, scale);
    const TriMesh other = turned_over(scaled(small, scale));
    EXPECT_EQ(inside_out_of({one, other}), std::vector<std::size_t>{1});
    EXPECT_EQ(inside_out_of({other, one}), std::vector<std::size_t>{0});
    EXPECT_EQ(inside_out_of({one, turned_over(one)}), std::vector<std::size_t>{});
  }
}

TEST(FindInsideOut, InATieTheFirstStays) {
  const TriMesh one = meshes::flat_grid(4, 5);
  TriMesh other = one;
  for (Vec3& p : other.positions)
    p.x += 4.0;
  EXPECT_EQ(inside_out_of({one, turned_over(other)}), std::vector<std::size_t>{1});
  EXPECT_EQ(inside_out_of({turned_over(other), one}), std::vector<std::size_t>{1});
}

/// Of three borders on one curve some two always run the same way.
TEST(FindInsideOut, ACurveOfThreePiecesTellsNothing) {
  const auto [one, other, third] = repairs::three_on_one_line();
  EXPECT_TRUE(inside_out_of({one, other, third}).empty());
}

}  // namespace
}  // namespace planish
