#include "evolve/systems/least_norm_step.h"

#include <cmath>
#include <utility>

namespace planish {

LeastNormStep::LeastNormStep(PatchState& state, std::vector<double> inverse_weights,
                             double max_step, ThreadPool& pool, Precision precision)
    : state_(state),
      pool_(pool),
      inverse_weights_(std::move(inverse_weights)),
      max_step_(max_step),
      jacobian_(angle_jacobian_of(state)),
      dual_(jacobian_, state, precision) {}

Positions LeastNormStep::step_for(const Eigen::VectorXd& angle_change) {
  Positions move = jacobian_.transposed_times(dual_.solve(angle_change, pool_), pool_);
  for (std::size_t v = 0; v < move.size(); ++v)
    move[v] = inverse_weights_[v] * move[v];
  return move;
}

Positions LeastNormStep::Curve::move(double t) const {
  return sum_of(sum_of(Positions(first.size()), t, first), 0.5 * t * t, second);
}

LeastNormStep::Curve LeastNormStep::to_close_defects() {
  constexpr double look = 0.2, most_bend = 0.5;
  const Positions x = inner_positions(state_);
  const Eigen::VectorXd d = inner_defects(state_);
  Curve curve{step_for(d), Positions(x.size())};
  const Eigen::VectorXd change = jacobian_.times(curve.first);
  curve.fall = 2.0 * d.dot(change);
  curve.solves = (d - change).norm() <= 0.1 * d.norm();
  const Positions ahead = stopped(sum_of(Positions(x.size()), look, curve.first));
  set_positions(sum_of(x, 1.0, ahead), jacobian_, state_);
  state_.measure(pool_);
  const Eigen::VectorXd missed = inner_defects(state_) - d + jacobian_.times(ahead);
  set_positions(x, jacobian_, state_);
  const Positions second = step_for((2.0 / (look * look)) * missed);
  const double bend = norm_of(second), limit = most_bend * norm_of(curve.first);
  if (std::isfinite(bend))
    curve.second = sum_of(curve.second, bend > limit ? limit / bend : 1.0, second);
  return curve;
}

Positions LeastNormStep::stopped(Positions move) const {
  pool_.for_ranges(move.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const double length = norm(move[v]);
      const double most = max_step_ * edges_at(static_cast<Index>(v), jacobian_, state_).shortest;
      if (length > most) move[v] = (most / length) * move[v];
    }
  });
  return move;
}

}  // namespace planish
