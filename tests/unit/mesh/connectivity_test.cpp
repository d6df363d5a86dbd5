#include <algorithm>

#include <planish/core/error.h>
#include <planish/mesh/connectivity.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "oracle/plain.h"
#include "support/meshes.h"

namespace planish {
namespace {

std::vector<Index> to_vector(std::span<const Index> values) {
  return {values.begin(), values.end()};
}

TEST(Connectivity, OrdersTheRingOfAnInnerVertexCounterClockwise) {
  const Connectivity connectivity(meshes::fan(5));
  EXPECT_EQ(to_vector(connectivity.ring(0)), (std::vector<Index>{1, 2, 3, 4, 5}));
  EXPECT_TRUE(connectivity.is_inner(0));
  EXPECT_FALSE(connectivity.is_border(0));
}

TEST(Connectivity, OpensTheRingOfABorderVertexAtTheNextOne) {
  const Connectivity connectivity(meshes::fan(5));
  EXPECT_EQ(to_vector(connectivity.ring(1)), (std::vector<Index>{2, 0, 5}));
  EXPECT_TRUE(connectivity.is_border(1));
}

TEST(Connectivity, FollowsTheBorderWithThePatchOnItsLeft) {
  const Connectivity connectivity(meshes::fan(4));
  ASSERT_EQ(connectivity.border_loops().size(), 1U);
  EXPECT_EQ(connectivity.border_loops()[0], (std::vector<Index>{1, 2, 3, 4}));
}

TEST(Connectivity, FindsBothLoopsOfATube) {
  const Connectivity connectivity(meshes::tube(6, 3));
  ASSERT_EQ(connectivity.border_loops().size(), 2U);
  EXPECT_EQ(connectivity.border_loops()[0].size(), 6U);
  EXPECT_EQ(connectivity.border_loops()[1].front(), 18U);
  EXPECT_EQ(connectivity.inner_vertices().size(), 12U);
}

TEST(Connectivity, KeepsUnusedVerticesWithoutRings) {
  TriMesh mesh = meshes::fan(4);
  mesh.positions.insert(mesh.positions.begin(), Vec3{9, 9, 9});
  for (Triangle& t : mesh.triangles) {
    for (Index& v : t)
      ++v;
  }
  const Connectivity connectivity(mesh);
  EXPECT_EQ(connectivity.vertex_count(), 6U);
  EXPECT_TRUE(connectivity.ring(0).empty());
  EXPECT_FALSE(connectivity.is_inner(0));
  EXPECT_FALSE(connectivity.is_border(0));
  EXPECT_EQ(to_vector(connectivity.inner_vertices()), (std::vector<Index>{1}));
}

TEST(Connectivity, AgreesWithASearchThroughAllTriangles) {
  for (const Shape& shape : shapes()) {
    const TriMesh mesh = make_shape(shape.name, 400);
    const Connectivity connectivity(mesh);
    const plain::Patch patch(mesh);
    for (Index v = 0; v < mesh.positions.size(); ++v) {
      ASSERT_EQ(connectivity.is_inner(v), patch.inner[v]) << shape.name << " " << v;
      if (!patch.inner[v]) continue;
      std::vector<Index> ring = to_vector(connectivity.ring(v));
      const std::vector<Index> expected = patch.ring(v);
      std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), expected[0]), ring.end());
      ASSERT_EQ(ring, expected) << shape.name << " " << v;
    }
  }
}

TEST(Connectivity, TakesLinearTimeAroundAVertexOfAnyValence) {
  // 200,000 triangles at one vertex: quadratic work would not end within the test's time.
  const Connectivity connectivity(meshes::fan(200'000));
  EXPECT_EQ(connectivity.ring(0).size(), 200'000U);
}

TEST(Connectivity, NamesTheProblemThatKeepsItFromBeingBuilt) {
  TriMesh mesh = meshes::fan(4);
  mesh.triangles.push_back({0, 1, 3});
  try {
    const Connectivity connectivity(mesh);
    FAIL() << "built a mesh that is not manifold";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::non_manifold_edge);
  }
}

}  // namespace
}  // namespace planish
