// Least norm: C. C. L. Wang, "A least-norm approach to flattenable mesh surface processing", SMI
// 2008, with damping and scale-free stops. Equations in docs/methods/least_norm.md.

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include <planish/evolve/method.h>

#include "evolve/dual_system.h"
#include "evolve/fairing.h"
#include "evolve/places.h"
#include "evolve/sweep.h"

namespace planish {

namespace {

/// By inner vertex: what the user said, and what is asked for next to the border.
std::vector<double> weights_of(const PatchState& state, double border_weight) {
  std::vector<double> weights;
  for (Index v = 0; const auto ring : rings_by_vertex(state.plan())) {
    const bool at_border =
        std::any_of(ring.begin(), ring.end(), [&](Index w) { return !state.is_inner(w); });
    weights.push_back(state.weight(v++) * (at_border ? border_weight : 1.0));
  }
  return weights;
}

std::size_t count_differences(const Places& a, const Places& b) {
  std::size_t count = 0;
  for (std::size_t v = 0; v < a.size(); ++v)
    count += a[v] != b[v] ? 1 : 0;
  return count;
}

class LeastNormStepper {
 public:
  LeastNormStepper(const LeastNorm& options, PatchState& state, ThreadPool& pool)
      : options_(options),
        state_(state),
        pool_(pool),
        jacobian_(state),
        dual_(jacobian_, state),
        direct_(options.update == LeastNormUpdate::direct) {
    const std::vector<double> weights = weights_of(state, options.border_weight);
    for (const double w : weights)
      squeeze_.push_back(1.0 / (w * w));
    if (direct_) return;
    const bool cotangent = options.update == LeastNormUpdate::cotangent;
    const auto kind = cotangent ? LaplacianWeights::cotangent : LaplacianWeights::uniform;
    fairing_.emplace(state, jacobian_.movable(), kind, weights, pool);
    fairing_damping_ = options.damping > 0.0 ? options.damping : cotangent ? 3e-6 : 3e-4;
    direct_ = !fairing_->solvable();
  }

  SweepOutcome step() {
    const Flattenability now = state_.measure(pool_);
    direct_ = direct_ || time_to_switch(now.e_max);
    if (direct_) fairing_.reset();
    ++steps_;
    last_e_max_ = now.e_max;
    jacobian_.update(pool_);
    return direct_ ? direct_step(now.energy) : faired_step();
  }

 private:
  bool time_to_switch(double e_max) const {
    return e_max < options_.switch_e_max ||
           (steps_ >= options_.switch_after && last_e_max_ - e_max < options_.switch_fall);
  }

  /// The least move, by weights, that turns the angle sums by as much as asked, as far as the
  /// damping that was factored with lets it: S A^T (A S A^T + mu D)^-1 turn.
  Places least_move(const Eigen::VectorXd& turn) const {
    Places move = jacobian_.transposed_times(dual_.solve(turn));
    for (std::size_t v = 0; v < move.size(); ++v)
      move[v] = squeeze_[v] * move[v];
    return move;
  }

  /// Infinite where a place is no number.
  double energy_at(const Places& x) {
    if (!std::isfinite(norm_of(x))) return std::numeric_limits<double>::infinity();
    move_to(x, jacobian_, state_);
    return state_.measure(pool_).energy;
  }

  SweepOutcome faired_step() {
    direct_ = !dual_.factor(squeeze_, fairing_damping_, pool_);
    if (direct_) return direct_step(state_.measure(pool_).energy);
    Places x = inner_places(state_);
    const Places move = least_move(inner_defects(state_));
    for (Index v = 0; v < x.size(); ++v) {
      // Where the matrix is nearly singular a vertex would fly off; a mean edge is far enough.
      const double length = norm(move[v]), most = edges_at(v, jacobian_, state_).mean;
      x[v] += (length > most ? most / length : 1.0) * move[v];
    }
    return {move_to(fairing_->apply(std::move(x)), jacobian_, state_)};
  }

  /// A move and how its end bends: the first t of it are t first + t^2/2 second.
  struct Curve {
    Places first, second;
    double fall = 0.0;  // of the energy, to first order
    bool solves =
        false;  // whether it closes the angle sums to first order: damping may keep it from it
    Places move(double t) const {
      return sum_of(sum_of(Places(first.size()), t, first), 0.5 * t * t, second);
    }
  };

  /// The move with every vertex stopped at so much of its shortest edge: a few needles must not
  /// hold up the rest.
  Places stopped(Places move) const {
    for (Index v = 0; v < move.size(); ++v) {
      const double length = norm(move[v]);
      const double most = options_.max_step * edges_at(v, jacobian_, state_).shortest;
      if (length > most) move[v] = (most / length) * move[v];
    }
    return move;
  }

  /// The least move, bent so that the angle sums go on straight to second order (geodesic
  /// acceleration, Transtrum and Sethna 2012): the second derivative of the angle sums along the
  /// move is what one look ahead shows them to miss.
  Curve least_curve(const Places& x) {
    constexpr double look = 0.2, most_bend = 0.5;
    const Eigen::VectorXd d = inner_defects(state_);
    Curve curve{least_move(d), Places(x.size())};
    const Eigen::VectorXd turn = jacobian_.times(curve.first);
    curve.fall = 2.0 * d.dot(turn);
    curve.solves = (d - turn).norm() <= 0.1 * d.norm();
    const Places ahead = stopped(sum_of(Places(x.size()), look, curve.first));
    move_to(sum_of(x, 1.0, ahead), jacobian_, state_);
    state_.measure(pool_);
    const Eigen::VectorXd missed = inner_defects(state_) - d + jacobian_.times(ahead);
    move_to(x, jacobian_, state_);
    const Places second = least_move((2.0 / (look * look)) * missed);
    const double bend = norm_of(second), limit = most_bend * norm_of(curve.first);
    if (std::isfinite(bend))
      curve.second = sum_of(curve.second, bend > limit ? limit / bend : 1.0, second);
    return curve;
  }

  /// Levenberg and Marquardt's step, halved until the energy falls. The damping follows what the
  /// step was worth.
  SweepOutcome direct_step(double energy) {
    constexpr int most_dampings = 12, most_halvings = 10;
    // Of what the slope foretells, and of the energy: less is not worth a step.
    constexpr double least_share = 1e-4, least_fall = 1e-6;
    constexpr double ease = 0.25, tighten = 4.0, most_damping = 1e8;
    const Places x = inner_places(state_);
    for (int i = 0; i < most_dampings; ++i, damping_ = std::min(10.0 * damping_, most_damping)) {
      if (!dual_.factor(squeeze_, damping_, pool_)) continue;
      const Curve curve = least_curve(x);
      const bool tiny = curve.solves && norm_of(curve.first) <= smallest_move();
      double share = 1.0;
      for (int halvings = 0; halvings < most_halvings; ++halvings, share *= 0.5) {
        const Places trial = sum_of(x, 1.0, stopped(curve.move(share)));
        const double fall = energy - energy_at(trial);
        if (!(fall > std::max(least_share * share * curve.fall, least_fall * energy))) continue;
        if (halvings == 0) damping_ = std::max(ease * damping_, 1e-12);
        if (halvings >= 2) damping_ = std::min(tighten * damping_, most_damping);
        return {count_differences(x, trial), tiny && halvings == 0};
      }
      move_to(x, jacobian_, state_);
      state_.measure(pool_);
      if (tiny) return {0, true};  // rounding is all that is left
    }
    return {};
  }

  /// The norm of a move whose rms is as small as asked.
  double smallest_move() const {
    const double rms = options_.min_step * mean_edge(jacobian_, state_);
    return rms * std::sqrt(static_cast<double>(state_.inner_count()));
  }

  LeastNorm options_;
  PatchState& state_;
  ThreadPool& pool_;
  AngleJacobian jacobian_;
  DualSystem dual_;
  std::optional<Fairing> fairing_;
  std::vector<double> squeeze_;  // 1/w^2 by inner vertex
  double fairing_damping_ = 0.0, damping_ = 1e-3;
  double last_e_max_ = std::numeric_limits<double>::infinity();
  int steps_ = 0;
  bool direct_;
};

}  // namespace

Sweep make_sweep(const LeastNorm& options, PatchState& state, ThreadPool& pool) {
  const auto stepper = std::make_shared<LeastNormStepper>(options, state, pool);
  return [stepper] { return stepper->step(); };
}

}  // namespace planish
