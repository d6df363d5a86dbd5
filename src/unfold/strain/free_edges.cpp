#include "unfold/strain/free_edges.h"

#include <algorithm>

namespace planish {

std::array<Index, 2> lower_first(Index v, Index w) {
  return {std::min(v, w), std::max(v, w)};
}

FreeEdges::FreeEdges(std::span<const std::array<Index, 2>> edges) {
  sorted_.reserve(edges.size());
  for (const auto& [v, w] : edges)
    sorted_.push_back(lower_first(v, w));
  std::sort(sorted_.begin(), sorted_.end());
}

bool FreeEdges::has(Index v, Index w) const {
  return std::binary_search(sorted_.begin(), sorted_.end(), lower_first(v, w));
}

std::vector<std::array<Index, 2>> renumbered_edges(std::span<const std::array<Index, 2>> edges,
                                                   std::span<const Index> source) {
  const auto number_of = [source](Index v) {
    return static_cast<Index>(std::lower_bound(source.begin(), source.end(), v) - source.begin());
  };
  std::vector<std::array<Index, 2>> renumbered;
  renumbered.reserve(edges.size());
  for (const auto& [v, w] : edges)
    renumbered.push_back({number_of(v), number_of(w)});
  return renumbered;
}

}  // namespace planish
