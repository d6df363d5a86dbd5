#include <algorithm>
#include <utility>
#include <vector>

#include <planish/mesh/repair.h>

#include "mesh/cut/corner_fans.h"
#include "mesh/edge_sides.h"
#include "mesh/repair/repaired.h"

namespace planish {

namespace {

SeparatedMesh separated(const TriMesh& mesh, const std::vector<EdgeSides>& edges) {
  MeshOfFans fans = with_a_vertex_for_each(mesh, corner_fans(mesh, edges));
  SeparatedMesh result{unchanged(mesh)};
  result.mesh = std::move(fans.mesh);
  result.vertex_source = std::move(fans.source);
  result.places = fans.divided;
  return result;
}

std::size_t nonmanifold_edges(const std::vector<EdgeSides>& edges) {
  return static_cast<std::size_t>(std::count_if(
      edges.begin(), edges.end(), [](const EdgeSides& edge) { return edge.size() > 2; }));
}

}  // namespace

SeparatedMesh separate_touching(const TriMesh& mesh) {
  require_entries(mesh);
  const std::vector<EdgeSide> sides = sorted_sides(mesh);
  return separated(mesh, group_by_edge(sides));
}

SeparatedMesh divide_at_nonmanifold_edges(const TriMesh& mesh) {
  require_entries(mesh);
  const std::vector<EdgeSide> sides = sorted_sides(mesh);
  std::vector<EdgeSides> edges = group_by_edge(sides);
  const std::size_t before = nonmanifold_edges(edges);
  std::erase_if(edges, [](const EdgeSides& edge) { return edge.size() > 2; });
  SeparatedMesh result = separated(mesh, edges);
  const std::vector<EdgeSide> divided = sorted_sides(result.mesh);
  const std::size_t left = nonmanifold_edges(group_by_edge(divided));
  result.places = before > left ? before - left : 0;  // of one edge two can be left
  return result;
}

}  // namespace planish
