#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include <planish/core/error.h>
#include <planish/mesh/patch.h>
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
  const Patch patch(meshes::fan(5));
  EXPECT_EQ(to_vector(patch.ring(0)), (std::vector<Index>{1, 2, 3, 4, 5}));
  EXPECT_TRUE(patch.is_inner(0));
  EXPECT_FALSE(patch.is_border(0));
}

TEST(Connectivity, OpensTheRingOfABorderVertexAtTheNextOne) {
  const Patch patch(meshes::fan(5));
  EXPECT_EQ(to_vector(patch.ring(1)), (std::vector<Index>{2, 0, 5}));
  EXPECT_TRUE(patch.is_border(1));
}

TEST(Connectivity, FollowsTheBorderWithThePatchOnItsLeft) {
  const Patch patch(meshes::fan(4));
  ASSERT_EQ(patch.border_loops().size(), 1U);
  EXPECT_EQ(patch.border_loops()[0], (std::vector<Index>{1, 2, 3, 4}));
}

TEST(Connectivity, FindsBothLoopsOfATube) {
  const Patch patch(meshes::tube(6, 3));
  ASSERT_EQ(patch.border_loops().size(), 2U);
  EXPECT_EQ(patch.border_loops()[0].size(), 6U);
  EXPECT_EQ(patch.border_loops()[1].front(), 18U);
  EXPECT_EQ(patch.inner_vertices().size(), 12U);
}

TEST(Connectivity, KeepsUnusedVerticesWithoutRings) {
  TriMesh mesh = meshes::fan(4);
  mesh.positions.insert(mesh.positions.begin(), Vec3{9, 9, 9});
  for (Triangle& t : mesh.triangles) {
    for (Index& v : t)
      ++v;
  }
  const Patch patch(mesh);
  EXPECT_EQ(patch.vertex_count(), 6U);
  EXPECT_TRUE(patch.ring(0).empty());
  EXPECT_FALSE(patch.is_inner(0));
  EXPECT_FALSE(patch.is_border(0));
  EXPECT_EQ(to_vector(patch.inner_vertices()), (std::vector<Index>{1}));
}

TEST(Connectivity, AgreesWithASearchThroughAllTriangles) {
  for (const Shape& shape : shapes()) {
    const TriMesh mesh = make_shape(shape.name, 400);
    const Patch surface(mesh);
    const plain::Patch patch(mesh);
    for (Index v = 0; v < mesh.positions.size(); ++v) {
      ASSERT_EQ(surface.is_inner(v), patch.inner[v]) << shape.name << " " << v;
      if (!patch.inner[v]) continue;
      std::vector<Index> ring = to_vector(surface.ring(v));
      const std::vector<Index> expected = patch.ring(v);
      std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), expected[0]), ring.end());
      ASSERT_EQ(ring, expected) << shape.name << " " << v;
    }
  }
}

TEST(Connectivity, TakesLinearTimeAroundAVertexOfAnyValence) {
  // 200,000 triangles at one vertex: quadratic work would not end within the test's time.
  const Patch patch(meshes::fan(200'000));
  EXPECT_EQ(patch.ring(0).size(), 200'000U);
}

TEST(Connectivity, NamesTheProblemThatKeepsItFromBeingBuilt) {
  TriMesh mesh = meshes::fan(4);
  mesh.triangles.push_back({0, 1, 3});
  try {
    const Patch patch(mesh);
    FAIL() << "built a mesh that is not manifold";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::non_manifold_edge);
  }
}

void expect_same(const Inspection& a, const Inspection& b) {
  EXPECT_EQ(a.topology.vertices, b.topology.vertices);
  EXPECT_EQ(a.topology.edges, b.topology.edges);
  EXPECT_EQ(a.topology.inner_vertices, b.topology.inner_vertices);
  EXPECT_EQ(a.topology.border_loops, b.topology.border_loops);
  EXPECT_EQ(a.topology.components, b.topology.components);
  EXPECT_EQ(a.topology.euler_characteristic, b.topology.euler_characteristic);
  ASSERT_EQ(a.problems.size(), b.problems.size());
  for (std::size_t k = 0; k < a.problems.size(); ++k) {
    EXPECT_EQ(a.problems[k].code, b.problems[k].code);
    EXPECT_EQ(a.problems[k].message, b.problems[k].message);
    EXPECT_EQ(a.problems[k].count, b.problems[k].count);
    EXPECT_EQ(a.problems[k].first, b.problems[k].first);
  }
}

TEST(Patch, HasTheInspectionOfItsMesh) {
  TriMesh two = meshes::tube(6, 3);  // of several loops, with a vertex that nothing uses
  two.positions.push_back({9, 9, 9});
  for (const TriMesh& mesh : {make_shape("panel", 300), meshes::fan(5), two, TriMesh{}})
    expect_same(Patch(mesh).inspection(), inspect(mesh));
}

TEST(Patch, IsOfNoVerticesWithoutAMesh) {
  const Patch patch;
  expect_same(patch.inspection(), Patch(TriMesh{}).inspection());
  EXPECT_EQ(patch.unit_scale(), Patch(TriMesh{}).unit_scale());
  EXPECT_EQ(patch.connectivity().vertex_count(), 0U);
  EXPECT_TRUE(patch.edges().empty());
}

TEST(Patch, SharesItsTopologyWithCopiesAndMovedPatches) {
  const Patch patch(make_shape("panel", 300));
  const Patch copy = patch;
  EXPECT_EQ(&copy.connectivity(), &patch.connectivity());
  EXPECT_EQ(&copy.mesh(), &patch.mesh());
  std::vector<Vec3> positions = patch.positions();
  for (Vec3& p : positions)
    p = 4.0 * p;
  const Patch moved = patch.with_positions(positions);
  EXPECT_EQ(&moved.connectivity(), &patch.connectivity());
  EXPECT_EQ(moved.triangles(), patch.triangles());
  EXPECT_EQ(moved.positions(), positions);
  EXPECT_EQ(moved.unit_scale(), 0.25 * patch.unit_scale());
}

TEST(Patch, InspectsPositionsAnewWhereTheyMove) {
  const Patch patch(make_shape("panel", 300));
  const Index v = patch.inner_vertices()[40];
  std::vector<Vec3> touching = patch.positions(), broken = touching;
  touching[v] = touching[patch.ring(v).front()];
  broken[v].y = std::nan("");
  const auto expect_inspected = [](const Patch& moved) {
    expect_same(moved.inspection(), inspect(moved.mesh()));
  };
  const Patch of_no_length = patch.with_positions(touching),
              of_no_place = patch.with_positions(broken);
  EXPECT_EQ(blocking_problem(of_no_length.inspection(), Purpose::measure)->code,
            ErrorCode::zero_length_edge);
  EXPECT_EQ(blocking_problem(of_no_place.inspection(), Purpose::measure)->code,
            ErrorCode::non_finite_coordinate);
  expect_inspected(of_no_length);
  expect_inspected(of_no_place);
  for (const Patch& moved : {patch, of_no_length, of_no_place})
    expect_inspected(moved.with_positions(patch.positions()));
}

TEST(Patch, HasEveryEdgeOnceWithItsTriangles) {
  const Patch patch(meshes::tube(6, 3));
  std::set<Triangle> triangles;  // beginning at their smallest vertex
  const auto add = [](Triangle t, std::set<Triangle>& to) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    to.insert(t);
  };
  for (const Triangle& t : patch.triangles())
    add(t, triangles);
  std::set<Triangle> met;
  std::size_t border = 0, sides = 0;
  std::set<std::pair<Index, Index>> ends;
  for (const Edge& edge : patch.edges()) {
    EXPECT_LT(edge.from, edge.to);
    EXPECT_TRUE(ends.insert({edge.from, edge.to}).second);
    if (edge.is_border()) ++border;
    if (edge.left != Edge::none) add({edge.from, edge.to, edge.left}, met), ++sides;
    if (edge.right != Edge::none) add({edge.to, edge.from, edge.right}, met), ++sides;
  }
  EXPECT_EQ(met, triangles);
  EXPECT_EQ(sides, 3 * triangles.size()) << "each triangle at its three edges";
  EXPECT_EQ(border, 12U);
  EXPECT_EQ(ends.size(), patch.inspection().topology.edges);
}

TEST(Patch, RefusesOtherNumbersOfPositions) {
  const Patch patch(meshes::fan(5));
  EXPECT_THROW(patch.with_positions({{0, 0, 0}}), std::logic_error);
}

}  // namespace
}  // namespace planish
