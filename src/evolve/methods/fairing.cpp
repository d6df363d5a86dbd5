// Bi-Laplacian fairing with the border and its slant held: equations in docs/methods/fairing.md.

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <planish/evolve/method.h>

#include "evolve/state/sweep.h"
#include "evolve/systems/fairing_system.h"
#include "evolve/systems/positions.h"

namespace planish {

namespace {

class FairingStepper {
 public:
  FairingStepper(const BilaplacianFairing& options, PatchState& state, ThreadPool& pool)
      : options_(options),
        state_(state),
        pool_(pool),
        jacobian_(angle_jacobian_of(state)),
        origins_(inner_positions(state)) {
    const double pull = options.pull / static_cast<double>(state.inner_count());
    for (Index v = 0; v < state.inner_count(); ++v) {
      pulls_.push_back(pull * state.weight(v));
      const auto ring = jacobian_.ring(v);
      const bool at_border =
          std::any_of(ring.begin(), ring.end(), [&](Index w) { return !state.is_inner(w); });
      movable_.push_back(jacobian_.is_movable(v) && !at_border ? 1 : 0);
    }
  }

  SweepOutcome step() {
    const FairingSystem fairing(state_, movable_, LaplacianWeights::thin_plate, pulls_, pool_);
    if (!fairing.solvable()) return {};
    const Positions before = inner_positions(state_), after = fairing.apply(origins_, pool_);
    const double rms =
        norm_of(sum_of(after, -1.0, before)) / std::sqrt(static_cast<double>(state_.inner_count()));
    const double smallest = options_.min_step * mean_edge(jacobian_, state_);
    return SweepOutcome(set_positions(after, jacobian_, state_)).ended_if(rms <= smallest);
  }

 private:
  BilaplacianFairing options_;
  PatchState& state_;
  ThreadPool& pool_;
  AngleJacobian jacobian_;  // who is next to whom
  Positions origins_;
  std::vector<double> pulls_;           // by inner vertex
  std::vector<unsigned char> movable_;  // by inner vertex; those next to the border are not
};

}  // namespace

Sweep make_sweep(const BilaplacianFairing& options, PatchState& state, ThreadPool& pool) {
  auto stepper = std::make_shared<FairingStepper>(options, state, pool);
  return [stepper] { return stepper->step(); };
}

}  // namespace planish
