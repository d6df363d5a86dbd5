#include "mesh/match/borders.h"

#include <planish/mesh/patch.h>

namespace planish {

std::vector<BorderEdge> border_edges(std::span<const TriMesh> patches) {
  std::vector<BorderEdge> edges;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const Patch patch(patches[p]);
    for (const std::vector<Index>& loop : patch.border_loops()) {
      const std::size_t first = edges.size(), n = loop.size();
      for (std::size_t k = 0; k < n; ++k) {
        edges.push_back(
            {p, loop[k], loop[(k + 1) % n], first + (k + 1) % n, first + (k + n - 1) % n});
      }
    }
  }
  return edges;
}

}  // namespace planish
