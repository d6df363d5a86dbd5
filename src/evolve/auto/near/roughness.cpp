#include "evolve/auto/near/roughness.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "geometry/dihedral_angle.h"

namespace planish {

Roughness::Roughness(const PatchState& state) : state_(state) {
  struct Side {
    Index low, high, corner;
    bool upward;  // of the triangle's direction
  };
  const std::vector<Triangle> triangles = state.triangles();
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
      sides.push_back({low, high, t[(k + 2) % 3], t[k] == low});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.upward) > std::tie(b.low, b.high, b.upward);
  });
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const Side &left = sides[i], &right = sides[i + 1];
    if (left.low == right.low && left.high == right.high && left.upward && !right.upward)
      edges_.push_back({left.low, left.high, left.corner, right.corner});
  }
}

double Roughness::now() const {
  double sum = 0.0;
  for (const auto& [a, b, left, right] : edges_) {
    const double angle = dihedral_angle(state_.position(a), state_.position(b),
                                        state_.position(left), state_.position(right));
    sum += angle * angle;
  }
  if (edges_.empty()) return 0.0;
  return std::sqrt(sum / static_cast<double>(edges_.size())) * 180.0 / std::numbers::pi;
}

}  // namespace planish
