#include "mesh/half_edges.h"

#include <algorithm>
#include <vector>

#include <planish/mesh/inspect.h>
#include <planish/mesh/patch.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

TriMesh left_of(const TriMesh& mesh, const HalfEdges& half_edges) {
  TriMesh left{mesh.positions, {}};
  for (Index h = 0; h < half_edges.size(); h += 3) {
    if (!half_edges.is_alive(h)) continue;
    left.triangles.push_back({half_edges.from(h), half_edges.from(h + 1), half_edges.from(h + 2)});
  }
  return left;
}

/// The same rings, up to where a closed one begins, as those of the triangles that are left.
void expect_consistent(const TriMesh& mesh, const HalfEdges& half_edges) {
  const Patch patch(left_of(mesh, half_edges));
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    const auto expected = patch.ring(v);
    ASSERT_EQ(half_edges.is_used(v), !expected.empty());
    if (expected.empty()) continue;
    ASSERT_EQ(half_edges.is_border(v), patch.is_border(v));
    std::vector<Index> ring;
    half_edges.for_each_neighbor(v, [&](Index w) { ring.push_back(w); });
    if (!patch.is_border(v)) {
      std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), expected.front()), ring.end());
    } else {
      EXPECT_EQ(half_edges.next_on_border(v), expected.front());
      EXPECT_EQ(half_edges.from(half_edges.border_edge_to(v)), expected.back());
    }
    EXPECT_EQ(ring, std::vector<Index>(expected.begin(), expected.end()));
  }
}

TEST(HalfEdges, StayADiskThroughEveryAllowedChange) {
  const TriMesh mesh = meshes::flat_grid(6, 6);
  meshes::Random random(5);
  const auto draw = [&](std::size_t count) {
    return static_cast<Index>(0.5 * (1.0 + random.number()) * static_cast<double>(count));
  };
  HalfEdges half_edges(mesh);
  expect_consistent(mesh, half_edges);
  int collapses = 0, flips = 0;
  for (int i = 0; i < 3000; ++i) {
    const Index h = draw(half_edges.size());
    if (!half_edges.is_alive(h)) continue;
    const Index gone = random.number() < 0.0 ? half_edges.from(h) : half_edges.to(h);
    if (i % 10 != 0 && half_edges.may_flip(h)) {
      half_edges.flip(h);
      ++flips;
    } else if (i % 10 == 0 && half_edges.may_collapse(h, gone)) {
      half_edges.collapse(h, gone);
      ++collapses;
    }
    expect_consistent(mesh, half_edges);
    const Topology topology = inspect(left_of(mesh, half_edges)).topology;
    ASSERT_EQ(topology.euler_characteristic, 1);
    ASSERT_EQ(topology.border_loops, 1U);
  }
  EXPECT_GT(flips, 100);
  EXPECT_GT(collapses, 30);
}

TEST(HalfEdges, RefuseWhatWouldPinch) {
  // One triangle; and a strip of two, whose inner edge has both ends on the border.
  const TriMesh one{{{}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
  HalfEdges triangle(one);
  EXPECT_FALSE(triangle.may_collapse(0, 0));
  EXPECT_FALSE(triangle.may_flip(0));
  HalfEdges square(meshes::flat_grid(1, 1));  // 0 1 3, 0 3 2
  EXPECT_FALSE(square.may_collapse(2, 0));
  EXPECT_TRUE(square.may_collapse(0, 0));
  EXPECT_TRUE(square.may_flip(2));
}

}  // namespace
}  // namespace planish
