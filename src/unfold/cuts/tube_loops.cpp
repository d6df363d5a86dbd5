#include "unfold/cuts/tube_loops.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <planish/mesh/cut.h>

#include "geometry/angle_between.h"

namespace planish {

double turning_of(const Patch& patch, std::span<const Index> loop) {
  const double scale = patch.unit_scale();
  double turning = 0.0;
  for (const Index v : loop) {
    const auto ring = patch.ring(v);
    const auto arm = [&](Index w) {
      return scale * patch.positions()[w] - scale * patch.positions()[v];
    };
    turning += std::numbers::pi;
    for (std::size_t k = 1; k < ring.size(); ++k)
      turning -= angle_between(arm(ring[k - 1]), arm(ring[k]));
  }
  return turning;
}

std::vector<std::size_t> tube_loops(const Patch& patch) {
  const auto& loops = patch.border_loops();
  std::vector<std::size_t> tubes;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const double from_hole = turning_of(patch, loops[k]) + 2.0 * std::numbers::pi;
    if (!(std::abs(from_hole) <= std::numbers::pi)) tubes.push_back(k);
  }
  if (!tubes.empty() || loops.empty()) return tubes;
  const auto length = [&](const std::vector<Index>& loop) {
    return path_length(loop, patch.positions());
  };
  const auto longest =
      std::max_element(loops.begin(), loops.end(),
                       [&](const auto& a, const auto& b) { return length(a) < length(b); });
  return {static_cast<std::size_t>(longest - loops.begin())};
}

}  // namespace planish
