#include <algorithm>
#include <cstddef>
#include <vector>

#include <planish/unfold/unfold.h>

#include "geometry/crosses_itself.h"

namespace planish {

std::optional<Overlap> overlap_of(const Patch& patch, const Pattern& pattern) {
  if (!pattern.overlaps) return std::nullopt;
  constexpr std::size_t most = 1000;
  std::vector<Vec2> border;
  std::vector<std::size_t> sizes;
  for (const std::vector<Index>& loop : patch.border_loops()) {
    sizes.push_back(loop.size());
    for (const Index v : loop)
      border.push_back(pattern.positions[v]);
  }
  const std::vector<Vec2> places = self_crossings(border, LoopOrder(sizes), most);
  if (places.empty()) return std::nullopt;
  Overlap overlap{places.front(), places.front(), places.size()};
  for (const Vec2 p : places) {
    overlap.low = {std::min(overlap.low.x, p.x), std::min(overlap.low.y, p.y)};
    overlap.high = {std::max(overlap.high.x, p.x), std::max(overlap.high.y, p.y)};
  }
  return overlap;
}

}  // namespace planish
