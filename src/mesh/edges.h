#pragma once

#include <cstddef>

#include <planish/mesh/patch.h>

namespace planish {

/// Calls visit(edge) for every edge once, in the order of Patch::edges().
template <class Visit>
void for_each_edge(const Connectivity& connectivity, const Visit& visit) {
  for (Index v = 0; v < connectivity.vertex_count(); ++v) {
    const auto ring = connectivity.ring(v);
    const std::size_t n = ring.size();
    // The ends of an open ring are border edges.
    const bool closed = !connectivity.is_border(v);
    for (std::size_t j = 0; j < n; ++j) {
      if (ring[j] < v) continue;
      const Index left = j + 1 < n ? ring[j + 1] : closed ? ring[0] : Edge::none;
      const Index right = j > 0 ? ring[j - 1] : closed ? ring[n - 1] : Edge::none;
      visit(Edge{v, ring[j], left, right});
    }
  }
}

}  // namespace planish
