#include "unfold/cuts/handle_cuts.h"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <utility>

#include "mesh/cut/inside_paths.h"
#include "mesh/disjoint_sets.h"

namespace planish {

namespace {

/// From the border, or from a vertex where there is none.
InsidePaths::Tree shortest_paths(const Patch& patch) {
  InsidePaths inside(patch);
  if (!patch.border_loops().empty()) return inside.tree(patch.border_loops().front());
  const Index first = patch.triangles().front().front();
  return inside.tree(std::span(&first, 1));
}

/// From v back to where its path begins.
std::vector<Index> path_back(const InsidePaths::Tree& paths, Index v) {
  std::vector<Index> path = {v};
  while (paths.previous[path.back()] != path.back())
    path.push_back(paths.previous[path.back()]);
  return path;
}

/// An edge that no path takes.
struct Beyond {
  double loop;  ///< length of the loop that it closes
  Index from, to;
  Index left, right;  ///< triangles
};

std::vector<Beyond> edges_beyond(const Patch& patch, const InsidePaths::Tree& paths) {
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
  const InsidePaths::Tree paths = shortest_paths(patch);
  DisjointSets<Index> joined(patch.triangles().size());
  std::vector<std::vector<Index>> cuts;
  for (const Beyond& edge : edges_beyond(patch, paths)) {
    if (joined.first_of(edge.left) != joined.first_of(edge.right)) {
      joined.join(edge.left, edge.right);
      continue;
    }
    std::vector<Index> cut = path_back(paths, edge.from);
    std::reverse(cut.begin(), cut.end());
    const std::vector<Index> back = path_back(paths, edge.to);
    cut.insert(cut.end(), back.begin(), back.end());
    cuts.push_back(std::move(cut));
  }
  return cuts;
}

}  // namespace planish
