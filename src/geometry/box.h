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

/// Whether two boxes are farther apart than a margin along an axis.
inline bool are_apart(const Box& a, const Box& b, double margin) {
  const auto apart = [&](double Vec3::*x) {
    return a.high.*x < b.low.*x - margin || a.low.*x > b.high.*x + margin;
  };
  return apart(&Vec3::x) || apart(&Vec3::y) || apart(&Vec3::z);
}

/// unit_scale() of a mesh whose vertices have this box.
double unit_scale(const Box& box);

}  // namespace planish
