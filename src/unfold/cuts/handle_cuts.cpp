#include "unfold/cuts/handle_cuts.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>

#include "mesh/cut/inside_paths.h"
#include "mesh/disjoint_sets.h"

namespace planish {

namespace {

/// The shortest paths from the border, or from a vertex where there is none.
struct ShortestPaths {
  std::vector<double> distance;
  std::vector<Index> previous;  ///< of where they begin, itself

  explicit ShortestPaths(const Patch& patch)
      : distance(patch.vertex_count(), std::numeric_limits<double>::infinity()),
        previous(patch.vertex_count(), 0) {
    using Entry = std::pair<double, Index>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    const auto begin = [&](Index v) {
      distance[v] = 0.0;
      previous[v] = v;
      queue.emplace(0.0, v);
    };
    if (patch.border_loops().empty()) {
      begin(patch.triangles().front().front());
    } else {
      for (const Index v : patch.border_loops().front())
        begin(v);
    }
    const double scale = patch.unit_scale();
    while (!queue.empty()) {
      const auto [at, v] = queue.top();
      queue.pop();
      if (at > distance[v]) continue;
      for (const Index w : patch.ring(v)) {
        const double through =
            at + norm(scale * patch.positions()[w] - scale * patch.positions()[v]);
        if (!(through < distance[w])) continue;
        distance[w] = through;
        previous[w] = v;
        queue.emplace(through, w);
      }
    }
  }

  /// Back to where the path to v begins.
  std::vector<Index> back_from(Index v) const {
    std::vector<Index> path = {v};
    while (previous[path.back()] != path.back())
      path.push_back(previous[path.back()]);
    return path;
  }
};

/// An edge that no path takes.
struct Beyond {
  double loop;  ///< length of the loop that it closes
  Index from, to;
  Index left, right;  ///< triangles
};

std::vector<Beyond> edges_beyond(const Patch& patch, const ShortestPaths& paths) {
  std::map<std::array<Index, 2>, Index> left;  // triangle by the edge with it on the left
  const auto& triangles = patch.triangles();
  for (Index t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k)
      left[{triangles[t][k], triangles[t][(k + 1) % 3]}] = t;
  }
  std::vector<Beyond> beyond;
  for (const auto& [edge, triangle] : left) {
    const auto [v, w] = edge;
    const auto other = left.find({w, v});
    if (v > w || other == left.end()) continue;
    if (paths.previous[v] == w || paths.previous[w] == v) continue;
    const double length =
        norm(patch.unit_scale() * patch.positions()[w] - patch.unit_scale() * patch.positions()[v]);
    beyond.push_back(
        {paths.distance[v] + length + paths.distance[w], v, w, triangle, other->second});
  }
  std::stable_sort(beyond.begin(), beyond.end(),
                   [](const Beyond& a, const Beyond& b) { return a.loop > b.loop; });
  return beyond;
}

}  // namespace

std::vector<std::vector<Index>> handle_cuts(const Patch& patch) {
  const ShortestPaths paths(patch);
  DisjointSets<Index> joined(patch.triangles().size());
  std::vector<std::vector<Index>> cuts;
  for (const Beyond& edge : edges_beyond(patch, paths)) {
    if (joined.first_of(edge.left) != joined.first_of(edge.right)) {
      joined.join(edge.left, edge.right);
      continue;
    }
    std::vector<Index> cut = paths.back_from(edge.from);
    std::reverse(cut.begin(), cut.end());
    const std::vector<Index> back = paths.back_from(edge.to);
    cut.insert(cut.end(), back.begin(), back.end());
    cuts.push_back(std::move(cut));
  }
  return cuts;
}

}  // namespace planish
