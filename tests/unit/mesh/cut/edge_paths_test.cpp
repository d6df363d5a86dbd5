#include "mesh/cut/edge_paths.h"

#include <cmath>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

double length_of(const std::vector<Index>& path, const TriMesh& mesh) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
    length += norm(mesh.positions[path[i]] - mesh.positions[path[i - 1]]);
  return length;
}

/// The lengths of shortest paths from a vertex by relaxing every edge until nothing changes.
std::vector<double> plain_distances(const TriMesh& mesh, Index from) {
  std::vector<double> distance(mesh.positions.size(), HUGE_VAL);
  distance[from] = 0.0;
  for (bool changed = true; changed;) {
    changed = false;
    for (const Triangle& t : mesh.triangles) {
      for (std::size_t k = 0; k < 6; ++k) {
        const Index v = t[k % 3], w = t[(k < 3 ? k + 1 : k + 2) % 3];
        const double through_v = distance[v] + norm(mesh.positions[w] - mesh.positions[v]);
        if (through_v < distance[w]) distance[w] = through_v, changed = true;
      }
    }
  }
  return distance;
}

TEST(EdgePaths, FollowTheRowsColumnsAndDiagonalsOfAGrid) {
  const TriMesh mesh = meshes::flat_grid(4, 4);  // diagonals go up to the right
  const Patch patch(mesh);
  EdgePaths paths(patch);
  EXPECT_EQ(paths.between(5, 8), (std::vector<Index>{5, 6, 7, 8}));
  EXPECT_EQ(paths.between(22, 2), (std::vector<Index>{22, 17, 12, 7, 2}));
  EXPECT_EQ(paths.between(0, 24), (std::vector<Index>{0, 6, 12, 18, 24}));
  EXPECT_EQ(paths.between(7, 7), (std::vector<Index>{7}));
}

TEST(EdgePaths, AreAsShortAsCanBe) {
  const TriMesh mesh = meshes::rough_grid(9, 7, 5);
  const Patch patch(mesh);
  EdgePaths paths(patch);
  for (const Index from : {0U, 33U, 79U}) {
    const auto distances = plain_distances(mesh, from);
    for (Index to = 0; to < mesh.positions.size(); ++to) {
      const auto path = paths.between(from, to);
      ASSERT_TRUE(path);
      EXPECT_EQ(path->front(), from);
      EXPECT_EQ(path->back(), to);
      EXPECT_NEAR(length_of(*path, mesh), distances[to], 1e-12);
      for (std::size_t i = 1; i < path->size(); ++i) {
        const auto ring = patch.ring((*path)[i - 1]);
        EXPECT_NE(std::find(ring.begin(), ring.end(), (*path)[i]), ring.end());
      }
    }
  }
}

TEST(EdgePaths, AreNoneBetweenPartsOfAMesh) {
  const TriMesh mesh = meshes::side_by_side(meshes::flat_grid(2, 2), meshes::flat_grid(2, 2));
  const Patch patch(mesh);
  EdgePaths paths(patch);
  EXPECT_FALSE(paths.between(0, 12));
  EXPECT_EQ(paths.between(9, 11), (std::vector<Index>{9, 10, 11}));
}

}  // namespace
}  // namespace planish
