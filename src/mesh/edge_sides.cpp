#include "mesh/edge_sides.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace planish {

std::vector<EdgeSide> sorted_sides(const TriMesh& mesh, std::span<const unsigned char> skipped) {
  const auto for_each_side = [&](const auto& visit) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (!skipped.empty() && skipped[t] != 0) continue;
      for (unsigned char k = 0; k < 3; ++k) {
        const Index a = mesh.triangles[t][k], b = mesh.triangles[t][(k + 1) % 3];
        visit(EdgeSide{std::min(a, b), std::max(a, b), static_cast<Index>(t), k, a < b});
      }
    }
  };
  // A place for those of each smaller vertex: few, so that sorting them takes little.
  std::vector<std::size_t> begin(mesh.positions.size() + 1, 0);
  for_each_side([&](const EdgeSide& side) { ++begin[side.low + 1]; });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<EdgeSide> sides(begin.back());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for_each_side([&](const EdgeSide& side) { sides[next[side.low]++] = side; });
  for (std::size_t v = 0; v + 1 < begin.size(); ++v) {
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(begin[v]),
              sides.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]),
              [](const EdgeSide& a, const EdgeSide& b) {
                return std::tie(a.high, a.triangle, a.corner) <
                       std::tie(b.high, b.triangle, b.corner);
              });
  }
  return sides;
}

std::vector<EdgeSides> group_by_edge(const std::vector<EdgeSide>& sides) {
  std::vector<EdgeSides> edges;
  edges.reserve(sides.size() / 2);
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
