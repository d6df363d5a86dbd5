#include <algorithm>
#include <utility>

#include <planish/mesh/cut.h>

#include "core/math.h"
#include "mesh/cut/corner_fans.h"
#include "mesh/cut/cut_paths.h"
#include "mesh/edge_sides.h"

namespace planish {

namespace {

/// Triangles that share an edge which is not cut share its vertices.
CornerFans fans_of(const TriMesh& mesh, std::span<const EdgeEnds> cut) {
  const std::vector<EdgeSide> sides = sorted_sides(mesh);
  std::vector<EdgeSides> edges = group_by_edge(sides);
  std::erase_if(edges, [cut](const EdgeSides& edge) {
    return std::binary_search(cut.begin(), cut.end(), EdgeEnds{edge.begin->low, edge.begin->high});
  });
  return corner_fans(mesh, edges);
}

}  // namespace

CutMesh cut_open(const Patch& patch, std::span<const CutPath> paths) {
  std::vector<std::vector<Index>> full = full_paths(patch, paths);
  refuse_idle_cuts(patch, paths, full);
  return open_edges(patch, std::move(full));
}

CutMesh open_edges(const Patch& patch, std::vector<std::vector<Index>> paths) {
  const TriMesh& mesh = patch.mesh();
  CutMesh cut;
  cut.paths = std::move(paths);
  const std::vector<EdgeEnds> edges = edges_of(cut.paths);
  cut.edges = edges.size();
  for (const EdgeEnds& edge : edges)
    cut.length += path_length(edge, mesh.positions);

  MeshOfFans opened = with_a_vertex_for_each(mesh, fans_of(mesh, edges));
  cut.mesh = std::move(opened.mesh);
  cut.source = std::move(opened.source);
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
