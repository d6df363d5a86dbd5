#include "pattern/polygon/loop_box.h"

#include <algorithm>
#include <limits>

namespace planish {

LoopBox box_around(std::span<const Vec2> points) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  LoopBox box{{inf, inf}, {-inf, -inf}};
  for (const Vec2 p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

LoopBox loop_box(std::span<const Polygon> loops) {
  std::vector<Vec2> corners;
  for (const Polygon& loop : loops) {
    const LoopBox box = box_around(loop);
    corners.insert(corners.end(), {box.low, box.high});
  }
  return loops.empty() ? LoopBox{} : box_around(corners);
}

}  // namespace planish
