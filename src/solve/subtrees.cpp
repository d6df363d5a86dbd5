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
  const auto is_below = [&](std::size_t s, double most) { return work[s] <= most; };
  const auto is_root_below = [&](std::size_t s, double most) {
    const Index up = tree.parent[s];
    return is_below(s, most) && (up == Supernodes::k_root || !is_below(up, most));
  };
  const double part_most = all / (16.0 * threads), stage_most = all / 4.0;
  Subtrees split;
  double of_stage = 0.0;
  bool is_full = true;  // the last stage
  for (std::size_t s = 0; s < count; ++s) {
    if (split.stages.empty() || (is_full && is_below(s, stage_most))) {
      split.stages.push_back({});
      of_stage = 0.0;
    }
    if (is_root_below(s, part_most)) split.parts.push_back({begin[s], s + 1});
    if (!is_below(s, part_most)) split.top.push_back(static_cast<Index>(s));
    split.stages.back() = {split.parts.size(), split.top.size()};
    if (is_root_below(s, stage_most)) of_stage += work[s];
    is_full = of_stage >= 0.5 * stage_most;
  }
  std::size_t first = 0;
  for (const Subtrees::Stage& stage : split.stages) {
    std::stable_sort(
        split.parts.begin() + static_cast<std::ptrdiff_t>(first),
        split.parts.begin() + static_cast<std::ptrdiff_t>(stage.parts_end),
        [&](const auto& a, const auto& b) { return work[a.end - 1] > work[b.end - 1]; });
    first = stage.parts_end;
  }
  return split;
}

}  // namespace planish
