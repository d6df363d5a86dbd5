// Least norm: C. C. L. Wang, "A least-norm approach to flattenable mesh surface processing", SMI
// 2008, with damping and scale-free stops. Equations in docs/methods/least_norm.md.

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include <planish/evolve/method.h>

#include "evolve/state/sweep.h"
#include "evolve/systems/fairing_system.h"
#include "evolve/systems/least_norm_step.h"
#include "evolve/systems/positions.h"
#include "optimize/line_search.h"

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

std::vector<double> inverse_weights_of(const std::vector<double>& weights) {
  std::vector<double> inverse(weights);
  for (double& s : inverse)
    s = 1.0 / (s * s);
  return inverse;
}

std::size_t count_differences(const Positions& a, const Positions& b) {
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
        weights_(weights_of(state, options.border_weight)),
        least_(state, inverse_weights_of(weights_), options.max_step, pool),
        direct_(options.update == LeastNormUpdate::direct) {
    if (direct_) return;
    const bool cotangent = options.update == LeastNormUpdate::cotangent;
    const auto kind = cotangent ? LaplacianWeights::cotangent : LaplacianWeights::uniform;
    fairing_.emplace(state, least_.jacobian().movable(), kind, weights_, pool);
    fairing_damping_ = options.damping > 0.0 ? options.damping : cotangent ? 3e-6 : 3e-4;
    direct_ = !fairing_->solvable();
  }

  SweepOutcome step() {
    const Flattenability now = state_.measure(pool_);
    direct_ = direct_ || time_to_switch(now.e_max);
    if (direct_) fairing_.reset();
    ++steps_;
    last_e_max_ = now.e_max;
    least_.update();
    return direct_ ? direct_step(now.energy) : faired_step();
  }

 private:
  bool time_to_switch(double e_max) const {
    return e_max < options_.switch_e_max ||
           (steps_ >= options_.switch_after && last_e_max_ - e_max < options_.switch_fall);
  }

  /// Infinite where a place is no number.
  double energy_at(const Positions& x) {
    if (!std::isfinite(norm_of(x))) return std::numeric_limits<double>::infinity();
    set_positions(x, least_.jacobian(), state_);
    return state_.measure(pool_).energy;
  }

  SweepOutcome faired_step() {
    direct_ = !least_.factor(fairing_damping_);
    if (direct_) return direct_step(state_.measure(pool_).energy);
    Positions x = inner_positions(state_);
    const Positions move = least_.step_for(inner_defects(state_));
    for (Index v = 0; v < x.size(); ++v) {
      // Where the matrix is nearly singular a vertex would fly off; a mean edge is far enough.
      const double length = norm(move[v]), most = edges_at(v, least_.jacobian(), state_).mean;
      x[v] += (length > most ? most / length : 1.0) * move[v];
    }
    return {set_positions(fairing_->apply(std::move(x), pool_), least_.jacobian(), state_)};
  }

  /// Levenberg and Marquardt's step, halved until the energy falls. The damping follows what the
  /// step was worth.
  SweepOutcome direct_step(double energy) {
    constexpr int most_dampings = 12, most_halvings = 10;
    // Of what the slope foretells, and of the energy: less is not worth a step.
    constexpr double least_share = 1e-4, least_fall = 1e-6;
    constexpr DampingRule rule = {.ease = 0.25, .tighten = 4.0, .least = 1e-12, .most = 1e8};
    const Positions x = inner_positions(state_);
    for (int i = 0; i < most_dampings; ++i, damping_ = std::min(10.0 * damping_, rule.most)) {
      if (!least_.factor(damping_)) continue;
      const LeastNormStep::Curve curve = least_.to_close_defects();
      const bool tiny = curve.solves && norm_of(curve.first) <= smallest_move();
      Positions trial;
      const auto taken = backtrack(1.0, most_halvings, [&](double size, int) {
        trial = sum_of(x, 1.0, least_.stopped(curve.move(size)));
        const double fall = energy - energy_at(trial);
        return fall > std::max(least_share * size * curve.fall, least_fall * energy);
      });
      if (taken) {
        damping_ = rule.after(taken, damping_);
        return SweepOutcome(count_differences(x, trial)).ended_if(tiny && taken->halvings == 0);
      }
      set_positions(x, least_.jacobian(), state_);
      state_.measure(pool_);
      if (tiny) return SweepOutcome().ended(StopReason::converged);  // rounding is all that is left
    }
    return {};
  }

  /// The norm of a move whose rms is as small as asked.
  double smallest_move() const {
    const double rms = options_.min_step * mean_edge(least_.jacobian(), state_);
    return rms * std::sqrt(static_cast<double>(state_.inner_count()));
  }

  LeastNorm options_;
  PatchState& state_;
  ThreadPool& pool_;
  std::vector<double> weights_;
  LeastNormStep least_;
  std::optional<FairingSystem> fairing_;
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
