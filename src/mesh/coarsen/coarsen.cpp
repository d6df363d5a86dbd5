#include "mesh/coarsen/coarsen.h"

#include <numeric>
#include <utility>

#include "mesh/breadth_first.h"
#include "mesh/coarsen/coarsener.h"

namespace planish {

namespace {

CoarsePatch whole(const TriMesh& mesh) {
  CoarsePatch patch{mesh, std::vector<Index>(mesh.positions.size())};
  std::iota(patch.source.begin(), patch.source.end(), Index{0});
  return patch;
}

/// @param triangles of vertices by their place in `order`
CoarsePatch patch_of(const TriMesh& mesh, const std::vector<Triangle>& triangles,
                     const std::vector<Index>& order) {
  CoarsePatch patch;
  std::vector<Index> number(mesh.positions.size(), HalfEdges::none);
  for (const Triangle& t : triangles) {
    for (const Index v : t)
      number[order[v]] = 0;
  }
  for (Index v = 0; v < number.size(); ++v) {
    if (number[v] == HalfEdges::none) continue;
    number[v] = static_cast<Index>(patch.source.size());
    patch.source.push_back(v);
    patch.mesh.positions.push_back(mesh.positions[v]);
  }
  for (const Triangle& t : triangles)
    patch.mesh.triangles.push_back({number[order[t[0]]], number[order[t[1]]], number[order[t[2]]]});
  return patch;
}

}  // namespace

bool can_be_coarsened(const Patch& patch) {
  const Topology& topology = patch.inspection().topology;
  return topology.components == 1 && topology.border_loops > 0;
}

CoarsePatch coarsen(const Patch& patch, std::size_t vertices, CoarseBorder border,
                    std::span<const unsigned char> keep, const ThreadPool* pool) {
  if (vertices >= patch.vertex_count()) return whole(patch.mesh());
  const std::vector<Index> order = breadth_first_order(patch.connectivity());
  std::vector<unsigned char> kept(order.size(), 0);
  for (std::size_t i = 0; i < order.size() && !keep.empty(); ++i)
    kept[i] = keep[order[i]];
  Coarsener coarsener(patch.mesh(), order, vertices, border, std::move(kept));
  coarsener.run(pool);
  return patch_of(patch.mesh(), coarsener.triangles(), order);
}

}  // namespace planish
