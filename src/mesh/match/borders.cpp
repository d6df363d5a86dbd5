#include "mesh/match/borders.h"

namespace planish {

namespace {

void add_border(std::size_t number, const Patch& patch, std::vector<BorderEdge>& edges) {
  for (const std::vector<Index>& loop : patch.border_loops()) {
    const std::size_t first = edges.size(), n = loop.size();
    for (std::size_t k = 0; k < n; ++k) {
      edges.push_back(
          {number, loop[k], loop[(k + 1) % n], first + (k + 1) % n, first + (k + n - 1) % n});
    }
  }
}

}  // namespace

std::vector<BorderEdge> border_edges(std::span<const TriMesh> patches) {
  std::vector<BorderEdge> edges;
  for (std::size_t p = 0; p < patches.size(); ++p)
    add_border(p, Patch(patches[p]), edges);
  return edges;
}

std::vector<BorderEdge> border_edges(std::span<const Patch> patches) {
  std::vector<BorderEdge> edges;
  for (std::size_t p = 0; p < patches.size(); ++p)
    add_border(p, patches[p], edges);
  return edges;
}

}  // namespace planish
