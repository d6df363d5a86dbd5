#include "pattern/polygon/loop_box.h"

#include <algorithm>
#include <limits>

namespace planish {

LoopBox loop_box(std::span<const Polygon> loops) {
  if (loops.empty()) return {};
  constexpr double inf = std::numeric_limits<double>::infinity();
  LoopBox box{{inf, inf}, {-inf, -inf}};
  for (const Polygon& loop : loops) {
    for (const Vec2 p : loop) {
      box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
      box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
  }
  return box;
}

}  // namespace planish
