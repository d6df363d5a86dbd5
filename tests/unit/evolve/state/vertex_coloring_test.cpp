#include "evolve/state/vertex_coloring.h"

#include <algorithm>
#include <set>

#include <planish/mesh/patch.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "support/inner_rings.h"
#include "support/meshes.h"

namespace planish {
namespace {

Pieces cut(std::size_t count, std::size_t piece) {
  Pieces pieces;
  pieces.vertices = Buffer<Index>(count);
  pieces.piece_of = Buffer<Index>(count);
  for (std::size_t v = 0; v < count; ++v) {
    if (v % piece == 0) pieces.start.push_back(v);
    pieces.vertices[v] = static_cast<Index>(v);
    pieces.piece_of[v] = static_cast<Index>(v / piece);
  }
  pieces.start.push_back(count);
  return pieces;
}

/// Insides of pieces and the rest.
struct Outcome {
  std::vector<Index> colors;
  std::size_t rest;
  Index inside_colors, all_colors;
};

Outcome color(const meshes::InnerRingsOf& rings, std::size_t piece, unsigned threads = 2) {
  ThreadPool pool(threads);
  Colorer colorer(rings.view());
  const auto rest = colorer.color_insides(cut(rings.view().count(), piece), pool);
  const Index inside_colors = colorer.count();
  colorer.color_rest(rest);
  return {colorer.colors(), rest.size(), inside_colors, colorer.count()};
}

/// How many pairs of one colour see a common inner vertex.
std::size_t count_conflicts(const InnerRings& rings, const std::vector<Index>& colors) {
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

TEST(Coloring, KeepsVerticesOfOneColorApart) {
  for (const Shape& shape : shapes()) {
    const meshes::InnerRingsOf rings(make_shape(shape.name, 3000));
    for (const std::size_t piece : {200U, 10'000U}) {
      const Outcome outcome = color(rings, piece);
      EXPECT_EQ(count_conflicts(rings.view(), outcome.colors), 0U) << shape.name;
      EXPECT_LT(outcome.inside_colors, 20U) << shape.name;
      EXPECT_LT(outcome.all_colors, 40U) << shape.name;
      const auto [least, most] = std::minmax_element(outcome.colors.begin(), outcome.colors.end());
      EXPECT_EQ(*least, 0U);
      EXPECT_EQ(*most + 1, outcome.all_colors);
      EXPECT_EQ(outcome.rest == 0, piece == 10'000U) << shape.name;
    }
  }
}

TEST(Coloring, KeepsInsidesOfPiecesApart) {
  const meshes::InnerRingsOf rings(make_shape("panel", 3000));
  constexpr std::size_t piece = 700;
  const Outcome outcome = color(rings, piece);
  for (std::size_t v = 0; v < rings.view().count(); ++v) {
    if (outcome.colors[v] >= outcome.inside_colors) continue;
    for (const Index w : rings.view().of(v)) {
      if (w >= rings.view().count()) continue;
      EXPECT_EQ(w / piece, v / piece);
    }
  }
}

TEST(Coloring, IsTheSameOnAnyNumberOfThreads) {
  const meshes::InnerRingsOf rings(make_shape("panel", 40'000));
  const Outcome outcome = color(rings, 4096);
  EXPECT_EQ(color(rings, 4096, 1).colors, outcome.colors);
  EXPECT_EQ(color(rings, 4096, 4).colors, outcome.colors);
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
  const meshes::InnerRingsOf rings(wheel(500));
  const Outcome outcome = color(rings, 10'000);
  EXPECT_EQ(count_conflicts(rings.view(), outcome.colors), 0U);
  EXPECT_EQ(outcome.all_colors, 501U);
}

TEST(Coloring, TakesNearLinearTimeAroundAHub) {
  // 100,000 neighbours of one hub: going through its ring for each would take 10^10 steps.
  EXPECT_EQ(color(meshes::InnerRingsOf(wheel(100'000)), 200'000).all_colors, 100'001U);
}

}  // namespace
}  // namespace planish
