#pragma once

#include <algorithm>
#include <limits>

#include <planish/core/vec.h>

namespace planish {

/// The least box around some positions; without any its size is -infinity.
struct Box {
  static constexpr double inf = std::numeric_limits<double>::infinity();
  Vec3 low{inf, inf, inf}, high{-inf, -inf, -inf};

  void add(Vec3 p) { add(Box{p, p}); }
  void add(const Box& box) {
    low = {std::min(low.x, box.low.x), std::min(low.y, box.low.y), std::min(low.z, box.low.z)};
    high = {std::max(high.x, box.high.x), std::max(high.y, box.high.y),
            std::max(high.z, box.high.z)};
  }
};

/// unit_scale() of a mesh whose vertices have this box.
double unit_scale(const Box& box);

}  // namespace planish
