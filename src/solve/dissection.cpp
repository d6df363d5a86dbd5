#include "solve/dissection.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace planish {

namespace {

constexpr std::size_t k_leaf = 24;  // not worth halving
// Vertices with so many times the mean number of neighbours come last of all: inside, each would
// make all its neighbours separators.
constexpr std::size_t k_hub = 10;

using Coordinate = double Vec3::*;

Coordinate longest_axis(std::span<const Vec3> positions, std::span<const Index> part) {
  Coordinate longest = &Vec3::x;
  double extent = -1.0;
  for (const Coordinate axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Index v : part) {
      low = std::min(low, positions[v].*axis);
      high = std::max(high, positions[v].*axis);
    }
    if (high - low <= extent) continue;
    extent = high - low;
    longest = axis;
  }
  return longest;
}

class Dissection {
 public:
  Dissection(std::span<const Vec3> positions, const Graph& graph)
      : positions_(positions), graph_(graph), right_of_(positions.size(), 0) {}

  /// Puts the vertices of a part into elimination order.
  void order(std::span<Index> part) {
    if (part.size() <= k_leaf) return;
    const Coordinate axis = longest_axis(positions_, part);
    const auto middle = part.begin() + static_cast<std::ptrdiff_t>(part.size() / 2);
    std::nth_element(part.begin(), middle, part.end(), [&](Index a, Index b) {
      const double pa = positions_[a].*axis, pb = positions_[b].*axis;
      return pa < pb || (pa == pb && a < b);
    });
    const std::size_t mark = ++marks_;
    for (auto v = middle; v != part.end(); ++v)
      right_of_[*v] = mark;
    const auto separator = std::partition(part.begin(), middle, [&](Index v) {
      const auto next = graph_.of(v);
      return std::none_of(next.begin(), next.end(), [&](Index w) { return right_of_[w] == mark; });
    });
    const auto left_count = separator - part.begin();
    // left | separator | right  ->  left | right | separator
    std::rotate(separator, middle, part.end());
    const auto right_count = part.end() - middle;
    order(part.first(static_cast<std::size_t>(left_count)));
    order(
        part.subspan(static_cast<std::size_t>(left_count), static_cast<std::size_t>(right_count)));
  }

 private:
  std::span<const Vec3> positions_;
  const Graph& graph_;
  std::vector<std::size_t> right_of_;  // the last cut that the vertex was right of
  std::size_t marks_ = 0;
};

}  // namespace

std::vector<Index> nested_dissection(std::span<const Vec3> positions, const Graph& graph,
                                     std::vector<Index> vertices) {
  if (vertices.empty()) return vertices;
  const std::size_t mean = graph.neighbours.size() / vertices.size() + 1;
  const auto hubs = std::stable_partition(vertices.begin(), vertices.end(), [&](Index v) {
    return graph.of(v).size() <= k_hub * mean;
  });
  Dissection(positions, graph).order({vertices.begin(), hubs});
  return vertices;
}

std::vector<Index> nested_dissection(std::span<const Vec3> positions, const Graph& graph) {
  std::vector<Index> all(graph.vertex_count());
  std::iota(all.begin(), all.end(), Index{0});
  return nested_dissection(positions, graph, std::move(all));
}

}  // namespace planish
