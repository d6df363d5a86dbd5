#include "mesh/cut/corner_fans.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace planish {

namespace {

/// The corner of the side's triangle that is at one of its ends.
std::size_t corner_at(const EdgeSide& side, bool low) {
  const std::size_t from = side.corner;
  return 3 * static_cast<std::size_t>(side.triangle) +
         (low == side.forward ? from : (from + 1) % 3);
}

}  // namespace

CornerFans corner_fans(const TriMesh& mesh, const std::vector<EdgeSides>& edges) {
  CornerFans fans(3 * mesh.triangles.size());
  for (const EdgeSides& edge : edges) {
    for (const EdgeSide* side = edge.begin + 1; side < edge.end; ++side) {
      for (const bool low : {true, false})
        fans.join(corner_at(*edge.begin, low), corner_at(*side, low));
    }
  }
  return fans;
}

MeshOfFans with_a_vertex_for_each(const TriMesh& mesh, CornerFans fans) {
  MeshOfFans result{mesh, std::vector<Index>(mesh.positions.size())};
  std::iota(result.source.begin(), result.source.end(), Index{0});
  std::vector<unsigned char> taken(mesh.positions.size(), 0);
  std::vector<std::pair<Index, std::size_t>> copies;  // of which vertex, for which fan
  const std::size_t corners = 3 * mesh.triangles.size();
  for (std::size_t c = 0; c < corners; ++c) {
    if (fans.first_of(c) != c) continue;
    const Index v = mesh.triangles[c / 3][c % 3];
    if (taken[v] == 1) ++result.divided;
    if (taken[v] != 0) copies.emplace_back(v, c);
    taken[v] = taken[v] == 0 ? 1 : 2;
  }
  std::sort(copies.begin(), copies.end());
  std::vector<Index> number_of(corners, 0);  // by a fan's smallest corner; 0: the vertex itself
  for (const auto& [v, fan] : copies) {
    number_of[fan] = static_cast<Index>(result.mesh.positions.size());
    result.mesh.positions.push_back(mesh.positions[v]);
    result.source.push_back(v);
  }
  for (std::size_t c = 0; c < corners; ++c) {
    if (const Index copy = number_of[fans.first_of(c)]; copy != 0)
      result.mesh.triangles[c / 3][c % 3] = copy;
  }
  return result;
}

}  // namespace planish
