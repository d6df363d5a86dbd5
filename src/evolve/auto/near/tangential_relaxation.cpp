#include "evolve/auto/near/tangential_relaxation.h"

#include <algorithm>

#include "evolve/auto/shared/tuning.h"
#include "evolve/systems/positions.h"
#include "geometry/triangle_shape.h"

namespace planish {

using tuning::prefer_near::k_poor, tuning::prefer_near::k_worse;

TangentialRelaxation::TangentialRelaxation(const AngleJacobian& jacobian, PatchState& state)
    : jacobian_(jacobian), state_(state) {
  for (Index v = 0; v < jacobian.angle_count(); ++v)
    least_.push_back(std::min(k_poor, k_worse * worst_shape(v, state.position(v))));
}

double TangentialRelaxation::worst_shape(Index v, Vec3 place) const {
  const auto ring = jacobian_.ring(v);
  double worst = 1.0;
  for (std::size_t j = 0; j < ring.size(); ++j) {
    const Index next = ring[j + 1 < ring.size() ? j + 1 : 0];
    worst = std::min(worst, triangle_shape(place, state_.position(ring[j]), state_.position(next)));
  }
  return worst;
}

std::size_t TangentialRelaxation::relax() {
  std::size_t moved = 0;
  for (Index v = 0; v < jacobian_.angle_count(); ++v) {
    if (!jacobian_.is_movable(v)) continue;
    const Vec3 from = state_.position(v);
    double best = worst_shape(v, from);
    if (!(best < least_[v])) continue;
    const auto ring = jacobian_.ring(v);
    Vec3 slide;
    for (const Index w : ring)
      slide += (1.0 / static_cast<double>(ring.size())) * (state_.position(w) - from);
    const Vec3 normal = normal_at(v, jacobian_, state_);
    slide += -dot(slide, normal) * normal;
    Vec3 to = from;
    for (const double share : {1.0, 0.5, 0.25, 0.1}) {
      const Vec3 place = from + share * slide;
      const double shape = worst_shape(v, place);
      if (!(shape > best)) continue;
      best = shape;
      to = place;
    }
    if (to == from) continue;
    state_.move(v, to);
    ++moved;
  }
  return moved;
}

}  // namespace planish
