#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <planish/mesh/seams.h>

#include "mesh/match/border_lines.h"
#include "mesh/match/boundary_correspondences.h"

namespace planish {

namespace {

constexpr std::size_t k_fewest_beside = 8;

using PlacedEdge = std::tuple<std::size_t, Index, Index>;  // patch, and vertices in any order

PlacedEdge placed(std::size_t patch, Index a, Index b) {
  return {patch, std::min(a, b), std::max(a, b)};
}

std::set<PlacedEdge> edges_of(std::span<const Seam> seams) {
  std::set<PlacedEdge> edges;
  for (const Seam& seam : seams) {
    for (const SeamSide& side : seam.sides) {
      for (std::size_t k = 1; k < side.vertices.size(); ++k)
        edges.insert(placed(side.patch, side.vertices[k - 1], side.vertices[k]));
    }
  }
  return edges;
}

using EdgeBeside = std::pair<std::size_t, std::size_t>;  // an edge, and the patch of a border

/// Edges that a place inside, or both ends, lie beside another border.
std::set<EdgeBeside> edges_beside(const BorderLines& borders) {
  std::set<EdgeBeside> begins, edges;
  for (const BoundaryCorrespondence& two : find_boundary_correspondences(borders, 0.0)) {
    for (std::size_t side = 0; side < 2; ++side) {
      const BorderLoop& loop = borders.loops()[two.loops[side]];
      const bool is_vertex = two.at[side] == std::floor(two.at[side]);
      (is_vertex ? begins : edges)
          .insert(
              {borders.edge_at(loop, two.at[side]), borders.loops()[two.loops[1 - side]].patch});
    }
  }
  for (const auto& [e, patch] : begins)
    if (begins.count({borders.edges()[e].next, patch}) > 0) edges.insert({e, patch});
  return edges;
}

}  // namespace

std::vector<NearBorders> find_near_borders(std::span<const TriMesh> patches,
                                           std::span<const Seam> seams) {
  const BorderLines borders(patches);
  if (borders.edges().empty()) return {};
  const std::set<PlacedEdge> sewn = edges_of(seams);
  struct Found {
    std::size_t edges = 0;
    double length = 0.0;
  };
  std::map<std::pair<std::size_t, std::size_t>, Found> found;  // from the first to the second
  for (const auto& [e, other] : edges_beside(borders)) {
    const BorderEdge& edge = borders.edges()[e];
    if (sewn.count(placed(edge.patch, edge.from, edge.to)) > 0) continue;
    Found& here = found[{edge.patch, other}];
    ++here.edges;
    here.length += borders.length(e) * (edge.patch == other ? 0.5 : 1.0);
  }
  std::vector<NearBorders> near;
  for (const auto& [pair, here] : found) {
    const auto [first, second] = pair;
    const auto back = found.find({second, first});
    const bool is_mutual = back != found.end() && back->second.edges >= k_fewest_beside;
    if (first > second || here.edges < k_fewest_beside || !is_mutual) continue;
    near.push_back({{first, second}, std::min(here.length, back->second.length)});
  }
  return near;
}

}  // namespace planish
