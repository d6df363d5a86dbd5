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
// So many times that and planes part badly: edges along them are far longer than those across.
constexpr double k_bad_separator = 2.0;

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
  /// shortest; where all are bad, at half the way along the edges, if that is shorter.
  Halves halve(std::span<Index> part) {
    const double usual =
        k_usual_separator * std::sqrt(static_cast<double>(part.size()) * mean_valence_);
    const auto separator = [&](Halves halves) {
      return static_cast<double>(part.size() - halves.both());
    };
    const auto axes = axes_by_extent(positions_, part);
    Halves halves = cut_across(part, axes[0]);
    if (separator(halves) <= usual) return halves;
    std::size_t best = 0, most = halves.both();
    for (std::size_t i = 1; i < axes.size(); ++i) {
      halves = cut_across(part, axes[i]);
      if (halves.both() <= most) continue;
      best = i;
      most = halves.both();
    }
    if (static_cast<double>(part.size() - most) > k_bad_separator * usual) {
      halves = cut_along_edges(part);
      if (halves.both() > most) return halves;
    } else if (best + 1 == axes.size()) {
      return halves;
    }
    return cut_across(part, axes[best]);
  }

  Halves cut_across(std::span<Index> part, Coordinate axis) {
    return cut(part, [&](Index v) { return positions_[v].*axis; });
  }

  /// By the number of edges from a vertex at one end of the part.
  Halves cut_along_edges(std::span<Index> part) {
    count_edges_from(*std::min_element(part.begin(), part.end()), part);
    const Index end = *std::max_element(part.begin(), part.end(), [&](Index a, Index b) {
      return std::pair(edges_from_[a], a) < std::pair(edges_from_[b], b);
    });
    count_edges_from(end, part);
    return cut(part, [&](Index v) { return edges_from_[v]; });
  }

  /// Into edges_from_ of the part, on edges within it. Pieces of a part count on from each other.
  void count_edges_from(Index start, std::span<const Index> part) {
    constexpr Index unseen = std::numeric_limits<Index>::max();
    edges_from_.resize(positions_.size(), 0);
    const std::size_t mark = ++marks_;
    for (const Index v : part) {
      right_of_[v] = mark;
      edges_from_[v] = unseen;
    }
    std::vector<Index> reached;
    reached.reserve(part.size());
    const auto reach = [&](Index v, Index edges) {
      if (right_of_[v] != mark || edges_from_[v] != unseen) return;
      edges_from_[v] = edges;
      reached.push_back(v);
    };
    reach(start, 0);
    auto next_piece = part.begin();
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Index edges = edges_from_[reached.back()] + 1;
      while (reached.size() == i)
        reach(*next_piece++, edges);  // those that were reached before are passed over
      const Index v = reached[i];
      for (const Index w : graph_.of(v))
        reach(w, edges_from_[v] + 1);
    }
  }

  /// Puts the half with lower keys first, the upper one second, and last those of the lower one
  /// that touch the upper one.
  template <class Key>
  Halves cut(std::span<Index> part, const Key& key) {
    const auto middle = part.begin() + static_cast<std::ptrdiff_t>(part.size() / 2);
    std::nth_element(part.begin(), middle, part.end(), [&](Index a, Index b) {
      const auto ka = key(a), kb = key(b);
      return ka < kb || (ka == kb && a < b);
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
  std::vector<std::size_t> right_of_;  // the last cut that the vertex was right of, or last part
  std::vector<Index> edges_from_;      // of the last cut along edges
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
  const auto usual = static_cast<std::size_t>(hubs - vertices.begin());
  Dissection(positions, graph).order(std::span(vertices).first(usual));
  return vertices;
}

std::vector<Index> nested_dissection(std::span<const Vec3> positions, const Graph& graph) {
  std::vector<Index> all(graph.vertex_count());
  std::iota(all.begin(), all.end(), Index{0});
  return nested_dissection(positions, graph, std::move(all));
}

}  // namespace planish
