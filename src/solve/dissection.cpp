#include "solve/dissection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace planish {

namespace {

constexpr std::size_t k_leaf = 24;  // not worth halving
// Vertices with so many times the mean number of neighbours come last of all: inside, each would
// make all its neighbours separators.
constexpr std::size_t k_hub = 10;

// Times the root of vertices times mean valence: what a compact piece of a surface is parted by,
// and somewhat more, whether matrices join vertices one edge apart or two.
constexpr double k_usual_separator = 0.5;

using Coordinate = double Vec3::*;

/// Longest first.
std::array<Coordinate, 3> axes_by_extent(std::span<const Vec3> positions,
                                         std::span<const Index> part) {
  const auto with_extent = [&](Coordinate axis) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Index v : part) {
      low = std::min(low, positions[v].*axis);
      high = std::max(high, positions[v].*axis);
    }
    return std::pair{high - low, axis};
  };
  std::array axes = {with_extent(&Vec3::x), with_extent(&Vec3::y), with_extent(&Vec3::z)};
  std::stable_sort(axes.begin(), axes.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  return {axes[0].second, axes[1].second, axes[2].second};
}

class Dissection {
 public:
  Dissection(std::span<const Vec3> positions, const Graph& graph)
      : positions_(positions),
        graph_(graph),
        mean_valence_(static_cast<double>(graph.neighbours.size()) /
                      static_cast<double>(graph.vertex_count())),
        right_of_(positions.size(), 0) {}

  /// Puts the vertices of a part into elimination order. Leaves and separators are sorted by vertex
  /// number, because each standard library's nth_element() leaves another order.
  void order(std::span<Index> part) {
    if (part.size() <= k_leaf) {
      std::sort(part.begin(), part.end());
      return;
    }
    const Halves halves = halve(part);
    order(part.first(halves.left));
    order(part.subspan(halves.left, halves.right));
    std::sort(part.begin() + static_cast<std::ptrdiff_t>(halves.both()), part.end());
  }

 private:
  /// How many come first and second; the rest of a part is the separator.
  struct Halves {
    std::size_t left, right;
    std::size_t both() const { return left + right; }
  };

  /// Across the longest extent if that gives a usual separator, else across the axis that gives the
  /// shortest.
  Halves halve(std::span<Index> part) {
    const auto axes = axes_by_extent(positions_, part);
    Halves halves = cut_across(part, axes[0]);
    const auto separator = static_cast<double>(part.size() - halves.both());
    if (separator <=
        k_usual_separator * std::sqrt(static_cast<double>(part.size()) * mean_valence_))
      return halves;
    std::size_t best = 0, most = halves.both();
    for (std::size_t i = 1; i < axes.size(); ++i) {
      halves = cut_across(part, axes[i]);
      if (halves.both() <= most) continue;
      best = i;
      most = halves.both();
    }
    return best + 1 == axes.size() ? halves : cut_across(part, axes[best]);
  }

  /// Puts the lower half along the axis first, the upper one second, and last those of the lower
  /// one that touch the upper one.
  Halves cut_across(std::span<Index> part, Coordinate axis) {
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
    const Halves halves{static_cast<std::size_t>(separator - part.begin()),
                        static_cast<std::size_t>(part.end() - middle)};
    std::rotate(separator, middle, part.end());
    return halves;
  }

  std::span<const Vec3> positions_;
  const Graph& graph_;
  double mean_valence_;
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
