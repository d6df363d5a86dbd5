#include "evolve/methods/allowed_moves.h"

#include <algorithm>
#include <cmath>

#include "evolve/vertex_step/interval.h"

namespace planish {

AllowedMoves::AllowedMoves(const PatchState& state, double clearance, double radius)
    : state_(state), clearance_(clearance), radius_(radius) {
  if (!state.obstacle().triangles.empty()) obstacle_.emplace(state.obstacle());
}

std::optional<AllowedMoves::HalfSpace> AllowedMoves::half_space(Vec3 x, double reach) const {
  if (!obstacle_) return std::nullopt;
  const Distance distance = obstacle_->at(x);
  if (distance.value - clearance_ > reach) return std::nullopt;
  return HalfSpace{distance.gradient, clearance_ - distance.value};
}

Vec3 AllowedMoves::target_of(Index v, Vec3 x, Vec3 move, double longest) const {
  const double length = norm(move);
  if (!std::isfinite(length)) return x;
  Vec3 target = length > longest ? x + (longest / length) * move : x + move;
  if (obstacle_) target = away_from_obstacle(x, target, longest);
  const Interval steps = within_sphere({0.0, 1.0}, x, target - x, state_.origin(v), radius_);
  if (steps.high < 1.0) target = x + steps.high * (target - x);
  if (norm(target - state_.origin(v)) > radius_) return x;
  // Whatever was done before, this is what is promised.
  if (obstacle_ && obstacle_->at(target).value < std::min(clearance_, obstacle_->at(x).value))
    return x;
  return target;
}

/// The target, or if the obstacle is in the way a place beside it.
Vec3 AllowedMoves::away_from_obstacle(Vec3 from, Vec3 target, double longest) const {
  constexpr int k_tries = 4;           // corners have several faces
  const double hair = 1e-6 * longest;  // else rounding would put it inside again
  for (int i = 0; i < k_tries; ++i) {
    const Distance distance = obstacle_->at(target);
    if (distance.value >= clearance_) break;
    target += (clearance_ + hair - distance.value) * distance.gradient;
    const double length = norm(target - from);
    if (length > longest) target = from + (longest / length) * (target - from);
  }
  return target;
}

}  // namespace planish
