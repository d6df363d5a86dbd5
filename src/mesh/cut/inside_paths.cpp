#include "mesh/cut/inside_paths.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

namespace planish {

namespace {

constexpr double k_not_reached = std::numeric_limits<double>::infinity();

}  // namespace

bool is_border_edge(const Connectivity& connectivity, Index v, Index w) {
  if (!connectivity.is_border(v)) return false;
  const auto ring = connectivity.ring(v);
  return ring.front() == w || ring.back() == w;
}

InsidePaths::InsidePaths(const Patch& patch, std::span<const double> weights)
    : patch_(patch),
      scale_(patch.unit_scale()),
      weights_(weights.begin(), weights.end()),
      distance_(patch.vertex_count(), k_not_reached),
      previous_(patch.vertex_count(), 0) {}

std::optional<std::vector<Index>> InsidePaths::from(std::span<const Index> first,
                                                    const std::function<bool(Index)>& is_wanted) {
  const std::optional<Index> end = spread(first, is_wanted);
  std::optional<std::vector<Index>> path;
  if (end) {
    path.emplace(1, *end);
    for (Index at = *end; previous_[at] != at; at = previous_[at])
      path->push_back(previous_[at]);
    std::reverse(path->begin(), path->end());
  }
  forget();
  return path;
}

std::optional<Index> InsidePaths::farthest(Index first,
                                           const std::function<bool(Index)>& is_wanted) {
  std::optional<Index> last;
  spread(std::span(&first, 1), [&](Index v) {
    if (v != first && is_wanted(v)) last = v;
    return false;
  });
  forget();
  return last;
}

InsidePaths::Tree InsidePaths::tree(std::span<const Index> first) {
  spread(first, [](Index) { return false; });
  Tree tree{distance_, previous_};
  forget();
  return tree;
}

std::optional<Index> InsidePaths::spread(std::span<const Index> first,
                                         const std::function<bool(Index)>& at_vertex) {
  // Of equally near vertices the one with the smallest number is first.
  using Entry = std::pair<double, Index>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const Index v : first) {
    if (distance_[v] == 0.0) continue;
    distance_[v] = 0.0;
    previous_[v] = v;
    reached_.push_back(v);
    queue.emplace(0.0, v);
  }
  while (!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    ++looks_;
    if (distance > distance_[v]) continue;  // a shorter way was found since
    if (at_vertex(v)) return v;
    if (patch_.is_border(v) && previous_[v] != v) continue;
    for (const Index w : patch_.ring(v)) {
      const double through_v = distance + length_of(v, w);
      if (!(through_v < distance_[w]) || is_border_edge(patch_.connectivity(), v, w)) continue;
      if (distance_[w] == k_not_reached) reached_.push_back(w);
      distance_[w] = through_v;
      previous_[w] = v;
      queue.emplace(through_v, w);
    }
  }
  return std::nullopt;
}

double InsidePaths::length_of(Index v, Index w) const {
  const double length = norm(scale_ * patch_.positions()[w] - scale_ * patch_.positions()[v]);
  return weights_.empty() ? length : 0.5 * (weights_[v] + weights_[w]) * length;
}

void InsidePaths::forget() {
  for (const Index v : reached_)
    distance_[v] = k_not_reached;
  reached_.clear();
}

}  // namespace planish
