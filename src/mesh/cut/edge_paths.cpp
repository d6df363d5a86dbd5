#include "mesh/cut/edge_paths.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace planish {

namespace {

constexpr double k_unreached = std::numeric_limits<double>::infinity();

}  // namespace

EdgePaths::EdgePaths(const Patch& patch)
    : patch_(patch),
      scale_(patch.unit_scale()),
      distance_(patch.vertex_count(), k_unreached),
      previous_(patch.vertex_count(), 0) {}

std::optional<std::vector<Index>> EdgePaths::between(Index from, Index to) {
  spread(from, to);
  std::optional<std::vector<Index>> path;
  if (distance_[to] < k_unreached) {
    path.emplace();
    for (Index at = to; at != from; at = previous_[at])
      path->push_back(at);
    path->push_back(from);
    std::reverse(path->begin(), path->end());
  }
  for (const Index v : reached_)
    distance_[v] = k_unreached;
  reached_.clear();
  return path;
}

/// Finds the distances from `from` in increasing order, up to that of `to`.
void EdgePaths::spread(Index from, Index to) {
  // Of equally near vertices the one with the smallest number is first.
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  distance_[from] = 0.0;
  reached_.push_back(from);
  queue.emplace(0.0, from);
  while (!queue.empty() && queue.top().second != to) {
    const auto [distance, v] = queue.top();
    queue.pop();
    ++looks_;
    if (distance > distance_[v]) continue;  // a shorter way was found since
    for (const Index w : patch_.ring(v)) {
      const Vec3 edge = scale_ * patch_.positions()[w] - scale_ * patch_.positions()[v];
      const double through_v = distance + norm(edge);
      if (!(through_v < distance_[w])) continue;
      if (distance_[w] == k_unreached) reached_.push_back(w);
      distance_[w] = through_v;
      previous_[w] = v;
      queue.emplace(through_v, w);
    }
  }
}

}  // namespace planish
