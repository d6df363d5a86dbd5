#include "mesh/split.h"

#include <algorithm>

#include <planish/core/error.h>
#include <planish/mesh/patch.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

/// Triangles left of the column, and right of it.
std::vector<Index> halves(const TriMesh& mesh, double column) {
  std::vector<Index> group;
  for (const Triangle& t : mesh.triangles) {
    double sum = 0.0;
    for (const Index v : t)
      sum += mesh.positions[v].x;
    group.push_back(sum < 3.0 * column ? 0 : 1);
  }
  return group;
}

TEST(Split, DividesByGroupsAndKeepsEveryBit) {
  const TriMesh mesh = meshes::rough_grid(8, 5, 3);
  const std::vector<std::string> names = {"left", "right"};
  const auto patches = split(mesh, halves(meshes::flat_grid(8, 5), 4.0), names);
  ASSERT_EQ(patches.size(), 2U);
  EXPECT_EQ(patches[0].name, "left");
  EXPECT_EQ(patches[1].name, "right");
  std::size_t triangles = 0;
  for (const NamedPatch& patch : patches) {
    triangles += patch.mesh.triangles.size();
    EXPECT_TRUE(std::is_sorted(patch.vertices.begin(), patch.vertices.end()));
    ASSERT_EQ(patch.vertices.size(), patch.mesh.positions.size());
    for (std::size_t v = 0; v < patch.vertices.size(); ++v)
      EXPECT_EQ(patch.mesh.positions[v], mesh.positions[patch.vertices[v]]);
    EXPECT_EQ(Patch(patch.mesh).border_loops().size(), 1U);
  }
  EXPECT_EQ(triangles, mesh.triangles.size());
  // The column in the middle is in both.
  EXPECT_EQ(patches[0].vertices.size() + patches[1].vertices.size(), mesh.positions.size() + 6);
}

TEST(Split, NumbersThePiecesOfAGroup) {
  const TriMesh one = meshes::flat_grid(3, 3);
  EXPECT_EQ(split(one, "sail").at(0).name, "sail");
  const auto two = split(meshes::side_by_side(one, one), "sail");
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[0].name, "sail-1");
  EXPECT_EQ(two[1].name, "sail-2");
  EXPECT_EQ(two[0].mesh.positions, one.positions);
  EXPECT_EQ(two[1].mesh.triangles, one.triangles);
}

TEST(Split, TakesWhatMeetsInOneVertexOnlyForTwoPieces) {
  const TriMesh mesh = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}},
                        {{0, 1, 2}, {0, 3, 4}}};
  EXPECT_EQ(split(mesh, "bow").size(), 2U);
}

TEST(Split, RefusesVerticesThatAreNotThere) {
  const TriMesh mesh = {{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 2}}};
  EXPECT_THROW(split(mesh, "bad"), Error);
}

}  // namespace
}  // namespace planish
