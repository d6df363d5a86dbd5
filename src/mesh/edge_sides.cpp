#include "mesh/edge_sides.h"

#include <algorithm>
#include <tuple>

namespace planish {

std::vector<EdgeSide> sorted_sides(const TriMesh& mesh, std::span<const unsigned char> skipped) {
  std::vector<EdgeSide> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!skipped.empty() && skipped[t] != 0) continue;
    for (unsigned char k = 0; k < 3; ++k) {
      const Index a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<Index>(t), k, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const EdgeSide& a, const EdgeSide& b) {
    return std::tie(a.low, a.high, a.triangle, a.corner) <
           std::tie(b.low, b.high, b.triangle, b.corner);
  });
  return sides;
}

std::vector<EdgeSides> group_by_edge(const std::vector<EdgeSide>& sides) {
  std::vector<EdgeSides> edges;
  for (const EdgeSide* begin = sides.data(); begin != sides.data() + sides.size();) {
    const EdgeSide* end = begin;
    while (end != sides.data() + sides.size() && end->same_edge(*begin))
      ++end;
    edges.push_back({begin, end});
    begin = end;
  }
  return edges;
}

}  // namespace planish
