#include "mesh/breadth_first.h"

#include <algorithm>

namespace planish {

std::vector<Index> breadth_first_order(const Connectivity& connectivity) {
  const std::size_t n = connectivity.vertex_count();
  std::vector<Index> order;
  order.reserve(n);
  std::vector<unsigned char> seen(n, 0);
  for (Index seed = 0; seed < n; ++seed) {
    if (seen[seed] != 0 || connectivity.ring(seed).empty()) continue;
    seen[seed] = 1;
    order.push_back(seed);
    for (std::size_t i = order.size() - 1; i < order.size(); ++i) {
      for (const Index w : connectivity.ring(order[i])) {
        if (seen[w] != 0) continue;
        seen[w] = 1;
        order.push_back(w);
      }
    }
  }
  return order;
}

TriMesh renumbered(const TriMesh& mesh, const std::vector<Index>& order) {
  TriMesh result;
  std::vector<Index> number(mesh.positions.size(), 0);
  result.positions.reserve(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    number[order[i]] = static_cast<Index>(i);
    result.positions.push_back(mesh.positions[order[i]]);
  }
  // Sorted by counting: start[v] is where the next triangle with v as its smallest vertex goes.
  const auto smallest = [&](const Triangle& t) {
    return std::min({number[t[0]], number[t[1]], number[t[2]]});
  };
  std::vector<std::size_t> start(order.size() + 1, 0);
  for (const Triangle& t : mesh.triangles)
    ++start[smallest(t) + 1];
  for (std::size_t v = 1; v < start.size(); ++v)
    start[v] += start[v - 1];
  result.triangles.resize(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles)
    result.triangles[start[smallest(t)]++] = {number[t[0]], number[t[1]], number[t[2]]};
  return result;
}

}  // namespace planish
