#include "evolve/coloring.h"

#include <algorithm>
#include <set>

#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

/// How many pairs of one colour see a common inner vertex.
std::size_t count_conflicts(const Connectivity& connectivity, const std::vector<Index>& colors) {
  std::size_t conflicts = 0;
  for (const Index v : connectivity.inner_vertices()) {
    // v and its inner neighbours are pairwise at distance two at most.
    std::multiset<Index> seen{colors[v]};
    for (const Index w : connectivity.ring(v)) {
      if (connectivity.is_inner(w)) seen.insert(colors[w]);
    }
    conflicts += seen.size() - std::set<Index>(seen.begin(), seen.end()).size();
  }
  return conflicts;
}

std::vector<Index> colors_of(const Connectivity& connectivity) {
  ThreadPool pool(2);
  return distance_two_colors(connectivity, connectivity.inner_vertices(), pool);
}

TEST(Coloring, KeepsVerticesOfOneColorApart) {
  for (const Shape& shape : shapes()) {
    const Connectivity connectivity(make_shape(shape.name, 3000));
    const auto colors = colors_of(connectivity);
    EXPECT_EQ(count_conflicts(connectivity, colors), 0U) << shape.name;
    EXPECT_LT(*std::max_element(colors.begin(), colors.end()), 32U) << shape.name;
  }
}

TEST(Coloring, OfManyPiecesKeepsVerticesApartOnAnyNumberOfThreads) {
  const TriMesh mesh = make_shape("panel", 40'000);
  const Connectivity connectivity(mesh);
  const auto colors = colors_of(connectivity);
  EXPECT_EQ(count_conflicts(connectivity, colors), 0U);
  ThreadPool alone(1);
  EXPECT_EQ(distance_two_colors(connectivity, connectivity.inner_vertices(), alone), colors);
}

/// A hub of high valence whose ring is inside: a fan with a second ring around it.
TriMesh wheel(std::size_t valence) {
  TriMesh mesh = meshes::fan(valence);
  const auto n = static_cast<Index>(valence);
  for (Index j = 1; j <= n; ++j)
    mesh.positions.push_back(2.0 * mesh.positions[j]);
  for (Index j = 0; j < n; ++j) {
    const Index a = 1 + j, b = 1 + (j + 1) % n;
    mesh.triangles.push_back({a, a + n, b + n});
    mesh.triangles.push_back({a, b + n, b});
  }
  return mesh;
}

TEST(Coloring, GivesEveryVertexAroundAHubItsOwnColor) {
  const Connectivity connectivity(wheel(500));
  const auto colors = colors_of(connectivity);
  EXPECT_EQ(count_conflicts(connectivity, colors), 0U);
  EXPECT_EQ(*std::max_element(colors.begin(), colors.end()), 500U);
}

TEST(Coloring, TakesNearLinearTimeAroundAHub) {
  // 100,000 neighbours of one hub: going through its ring for each would take 10^10 steps.
  const Connectivity connectivity(wheel(100'000));
  const auto colors = colors_of(connectivity);
  EXPECT_EQ(*std::max_element(colors.begin(), colors.end()), 100'000U);
}

}  // namespace
}  // namespace planish
