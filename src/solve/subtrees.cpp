#include "solve/subtrees.h"

#include <algorithm>

namespace planish {

double work_of(const Supernodes& tree, std::size_t node) {
  const double width = tree.width(node), below = static_cast<double>(tree.rows(node).size());
  const double size = width + below;
  // Sum of squares from below to size, halved; and the assembly of the front, of a few fronts' size
  // where they are narrow.
  return width * (size * size + size * below + below * below) / 6.0 + 4.0 * size * size;
}

Subtrees split_tree(const Supernodes& tree, unsigned threads) {
  const std::size_t count = tree.count();
  std::vector<double> work(count);  // of the subtree below each supernode
  std::vector<std::size_t> begin(count);
  double all = 0.0;
  for (std::size_t s = 0; s < count; ++s) {
    work[s] = work_of(tree, s);
    begin[s] = s;
    all += work[s];
  }
  for (std::size_t s = 0; s < count; ++s) {
    const Index up = tree.parent[s];
    if (up == Supernodes::k_root) continue;
    work[up] += work[s];
    begin[up] = std::min(begin[up], begin[s]);
  }
  const double most = all / (8.0 * threads);
  Subtrees split;
  for (std::size_t s = 0; s < count; ++s) {
    const Index up = tree.parent[s];
    if (work[s] > most) {
      split.top.push_back(static_cast<Index>(s));
    } else if (up == Supernodes::k_root || work[up] > most) {
      split.parts.push_back({begin[s], s + 1});
    }
  }
  std::stable_sort(split.parts.begin(), split.parts.end(),
                   [&](const auto& a, const auto& b) { return work[a.end - 1] > work[b.end - 1]; });
  return split;
}

}  // namespace planish
