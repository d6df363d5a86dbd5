#include <algorithm>
#include <numeric>
#include <utility>

#include <planish/mesh/cut.h>

#include "core/math.h"
#include "mesh/cut/cut_paths.h"
#include "mesh/disjoint_sets.h"

namespace planish {

namespace {

/// The corners of all triangles, 3 t + i for corner i of triangle t, put together in fans: those
/// around a vertex that are to share a copy of it.
using Fans = DisjointSets<std::size_t>;

/// One side of a triangle, from corner `from` of the mesh's corners to corner `to`.
struct TriangleSide {
  EdgeEnds edge;
  std::size_t from, to;
};

std::vector<TriangleSide> sides_by_edge(const TriMesh& mesh) {
  std::vector<TriangleSide> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& corners = mesh.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const Index v = corners[i], w = corners[(i + 1) % 3];
      sides.push_back({{std::min(v, w), std::max(v, w)}, 3 * t + i, 3 * t + (i + 1) % 3});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const TriangleSide& a, const TriangleSide& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.from < b.from;
  });
  return sides;
}

/// Triangles that share an edge which is not cut share its vertices.
Fans fans_of(const TriMesh& mesh, std::span<const EdgeEnds> cut) {
  const std::vector<TriangleSide> sides = sides_by_edge(mesh);
  Fans fans(3 * mesh.triangles.size());
  for (std::size_t s = 0; s + 1 < sides.size(); ++s) {
    if (sides[s].edge != sides[s + 1].edge) continue;
    if (std::binary_search(cut.begin(), cut.end(), sides[s].edge)) continue;
    // Oriented alike, they run against each other.
    fans.join(sides[s].from, sides[s + 1].to);
    fans.join(sides[s].to, sides[s + 1].from);
  }
  return fans;
}

}  // namespace

CutMesh cut_open(const Patch& patch, std::span<const CutPath> paths) {
  const TriMesh& mesh = patch.mesh();
  CutMesh cut{mesh, std::vector<Index>(mesh.positions.size()), full_paths(patch, paths)};
  std::iota(cut.source.begin(), cut.source.end(), Index{0});
  refuse_idle_cuts(patch, paths, cut.paths);
  const std::vector<EdgeEnds> edges = edges_of(cut.paths);
  cut.edges = edges.size();
  for (const EdgeEnds& edge : edges)
    cut.length += path_length(edge, mesh.positions);

  Fans fans = fans_of(mesh, edges);
  const std::size_t corners = 3 * mesh.triangles.size();
  std::vector<unsigned char> taken(mesh.positions.size(), 0);
  std::vector<std::pair<Index, std::size_t>> copies;  // of which vertex, for which fan
  for (std::size_t c = 0; c < corners; ++c) {
    if (fans.first_of(c) != c) continue;
    const Index v = mesh.triangles[c / 3][c % 3];
    if (taken[v] != 0) copies.emplace_back(v, c);
    taken[v] = 1;
  }
  std::sort(copies.begin(), copies.end());
  std::vector<Index> number_of(corners, 0);  // by a fan's smallest corner; 0: the vertex itself
  for (const auto& [v, fan] : copies) {
    number_of[fan] = static_cast<Index>(cut.mesh.positions.size());
    cut.mesh.positions.push_back(mesh.positions[v]);
    cut.source.push_back(v);
  }
  for (std::size_t c = 0; c < corners; ++c) {
    if (const Index copy = number_of[fans.first_of(c)]; copy != 0)
      cut.mesh.triangles[c / 3][c % 3] = copy;
  }
  return cut;
}

double path_length(std::span<const Index> path, std::span<const Vec3> positions) {
  double length = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const Vec3 edge = positions[path[i]] - positions[path[i - 1]];
    length += math::hypot(edge.x, edge.y, edge.z);  // squares might not be numbers any more
  }
  return length;
}

}  // namespace planish
