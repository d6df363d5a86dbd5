#include <algorithm>
#include <utility>
#include <vector>

#include <planish/mesh/repair.h>

#include "mesh/disjoint_sets.h"
#include "mesh/edge_sides.h"
#include "mesh/repair/repaired.h"

namespace planish {

namespace {

/// The corners of all triangles, 3 t + i for corner i of triangle t, in fans: those around a vertex
/// that hang together by edges.
using CornerFans = DisjointSets<std::size_t>;

/// The corner of the side's triangle that is at one of its ends.
std::size_t corner_at(const EdgeSide& side, bool low) {
  const std::size_t from = side.corner;
  return 3 * static_cast<std::size_t>(side.triangle) +
         (low == side.forward ? from : (from + 1) % 3);
}

/// @param most edges of more triangles hold nothing together; 0: all edges do
CornerFans corner_fans(const TriMesh& mesh, const std::vector<EdgeSides>& edges, std::size_t most) {
  CornerFans fans(3 * mesh.triangles.size());
  for (const EdgeSides& edge : edges) {
    if (most != 0 && edge.size() > most) continue;
    for (const EdgeSide* side = edge.begin + 1; side < edge.end; ++side) {
      for (const bool low : {true, false})
        fans.join(corner_at(*edge.begin, low), corner_at(*side, low));
    }
  }
  return fans;
}

/// Gives each fan but the first of each vertex a copy of it. Copies come by what they are copies
/// of.
SeparatedMesh with_a_vertex_for_each(const TriMesh& mesh, CornerFans fans) {
  SeparatedMesh result{unchanged(mesh)};
  std::vector<unsigned char> taken(mesh.positions.size(), 0);
  std::vector<std::pair<Index, std::size_t>> copies;  // of which vertex, for which fan
  const std::size_t corners = 3 * mesh.triangles.size();
  for (std::size_t c = 0; c < corners; ++c) {
    if (fans.first_of(c) != c) continue;
    const Index v = mesh.triangles[c / 3][c % 3];
    if (taken[v] == 1) ++result.places;
    if (taken[v] != 0) copies.emplace_back(v, c);
    taken[v] = taken[v] == 0 ? 1 : 2;
  }
  std::sort(copies.begin(), copies.end());
  std::vector<Index> number_of(corners, 0);  // by a fan's smallest corner; 0: the vertex itself
  for (const auto& [v, fan] : copies) {
    number_of[fan] = static_cast<Index>(result.mesh.positions.size());
    result.mesh.positions.push_back(mesh.positions[v]);
    result.vertex_source.push_back(v);
  }
  for (std::size_t c = 0; c < corners; ++c) {
    if (const Index copy = number_of[fans.first_of(c)]; copy != 0)
      result.mesh.triangles[c / 3][c % 3] = copy;
  }
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
  return with_a_vertex_for_each(mesh, corner_fans(mesh, group_by_edge(sides), 0));
}

SeparatedMesh divide_at_nonmanifold_edges(const TriMesh& mesh) {
  require_entries(mesh);
  const std::vector<EdgeSide> sides = sorted_sides(mesh);
  const std::vector<EdgeSides> edges = group_by_edge(sides);
  SeparatedMesh result = with_a_vertex_for_each(mesh, corner_fans(mesh, edges, 2));
  const std::vector<EdgeSide> divided = sorted_sides(result.mesh);
  result.places = nonmanifold_edges(edges) - nonmanifold_edges(group_by_edge(divided));
  return result;
}

}  // namespace planish
