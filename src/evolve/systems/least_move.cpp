#include "evolve/systems/least_move.h"

#include <cmath>
#include <utility>

namespace planish {

LeastMove::LeastMove(PatchState& state, std::vector<double> squeeze, double max_step,
                     ThreadPool& pool, Precision precision)
    : state_(state),
      pool_(pool),
      squeeze_(std::move(squeeze)),
      max_step_(max_step),
      jacobian_(state),
      dual_(jacobian_, state, precision) {}

Positions LeastMove::to_turn(const Eigen::VectorXd& turn) {
  Positions move = jacobian_.transposed_times(dual_.solve(turn, pool_));
  for (std::size_t v = 0; v < move.size(); ++v)
    move[v] = squeeze_[v] * move[v];
  return move;
}

Positions LeastMove::Curve::move(double t) const {
  return sum_of(sum_of(Positions(first.size()), t, first), 0.5 * t * t, second);
}

LeastMove::Curve LeastMove::to_close_defects() {
  constexpr double look = 0.2, most_bend = 0.5;
  const Positions x = inner_positions(state_);
  const Eigen::VectorXd d = inner_defects(state_);
  Curve curve{to_turn(d), Positions(x.size())};
  const Eigen::VectorXd turn = jacobian_.times(curve.first);
  curve.fall = 2.0 * d.dot(turn);
  curve.solves = (d - turn).norm() <= 0.1 * d.norm();
  const Positions ahead = stopped(sum_of(Positions(x.size()), look, curve.first));
  set_positions(sum_of(x, 1.0, ahead), jacobian_, state_);
  state_.measure(pool_);
  const Eigen::VectorXd missed = inner_defects(state_) - d + jacobian_.times(ahead);
  set_positions(x, jacobian_, state_);
  const Positions second = to_turn((2.0 / (look * look)) * missed);
  const double bend = norm_of(second), limit = most_bend * norm_of(curve.first);
  if (std::isfinite(bend))
    curve.second = sum_of(curve.second, bend > limit ? limit / bend : 1.0, second);
  return curve;
}

Positions LeastMove::stopped(Positions move) const {
  for (Index v = 0; v < move.size(); ++v) {
    const double length = norm(move[v]);
    const double most = max_step_ * edges_at(v, jacobian_, state_).shortest;
    if (length > most) move[v] = (most / length) * move[v];
  }
  return move;
}

}  // namespace planish
