#include "evolve/coloring.h"

#include <algorithm>
#include <set>

#include <planish/mesh/connectivity.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

/// The rings of the inner vertices of a mesh, inner ones numbered first.
struct Rings {
  std::vector<std::size_t> start{0};
  std::vector<Index> vertices;

  explicit Rings(const TriMesh& mesh) {
    const Connectivity connectivity(mesh);
    const auto inner = connectivity.inner_vertices();
    std::vector<Index> number(mesh.positions.size(), static_cast<Index>(mesh.positions.size()));
    for (std::size_t i = 0; i < inner.size(); ++i)
      number[inner[i]] = static_cast<Index>(i);
    for (const Index v : inner) {
      for (const Index w : connectivity.ring(v))
        vertices.push_back(number[w]);
      start.push_back(vertices.size());
    }
  }

  std::vector<Index> colors(unsigned threads = 2) const {
    ThreadPool pool(threads);
    return distance_two_colors({start, vertices}, pool);
  }

  /// How many pairs of one colour see a common inner vertex.
  std::size_t count_conflicts(const std::vector<Index>& colors) const {
    const InnerRings rings{start, vertices};
    std::size_t conflicts = 0;
    for (std::size_t v = 0; v < rings.count(); ++v) {
      // v and its inner neighbours are pairwise at distance two at most.
      std::multiset<Index> seen{colors[v]};
      for (const Index w : rings.of(v)) {
        if (w < rings.count()) seen.insert(colors[w]);
      }
      conflicts += seen.size() - std::set<Index>(seen.begin(), seen.end()).size();
    }
    return conflicts;
  }
};

TEST(Coloring, KeepsVerticesOfOneColorApart) {
  for (const Shape& shape : shapes()) {
    const Rings rings(make_shape(shape.name, 3000));
    const auto colors = rings.colors();
    EXPECT_EQ(rings.count_conflicts(colors), 0U) << shape.name;
    EXPECT_LT(*std::max_element(colors.begin(), colors.end()), 32U) << shape.name;
  }
}

TEST(Coloring, OfManyPiecesIsTheSameOnAnyNumberOfThreads) {
  const Rings rings(make_shape("panel", 40'000));
  const auto colors = rings.colors();
  EXPECT_EQ(rings.count_conflicts(colors), 0U);
  EXPECT_EQ(rings.colors(1), colors);
  EXPECT_EQ(rings.colors(4), colors);
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
  const Rings rings(wheel(500));
  const auto colors = rings.colors();
  EXPECT_EQ(rings.count_conflicts(colors), 0U);
  EXPECT_EQ(*std::max_element(colors.begin(), colors.end()), 500U);
}

TEST(Coloring, TakesNearLinearTimeAroundAHub) {
  // 100,000 neighbours of one hub: going through its ring for each would take 10^10 steps.
  const auto colors = Rings(wheel(100'000)).colors();
  EXPECT_EQ(*std::max_element(colors.begin(), colors.end()), 100'000U);
}

}  // namespace
}  // namespace planish
