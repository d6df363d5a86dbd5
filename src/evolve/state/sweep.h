#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>

#include <planish/evolve/evolver.h>
#include <planish/evolve/method.h>

#include "core/thread_pool.h"
#include "evolve/state/patch_state.h"

namespace planish {

/// What a pass did.
struct SweepOutcome {
  /// A pass that moved nothing has stalled: the next one would do the same.
  explicit(false) SweepOutcome(std::size_t vertices = 0)
      : moved(vertices), status(vertices > 0 ? SweepStatus::running : SweepStatus::stalled) {}

  SweepOutcome with(SweepStatus other) const {
    SweepOutcome outcome = *this;
    outcome.status = other;
    return outcome;
  }
  SweepOutcome ended(StopReason why) const {
    SweepOutcome outcome = with(SweepStatus::converged);
    outcome.reason = why;
    return outcome;
  }
  /// Ended as converged where that is true.
  SweepOutcome ended_if(bool is_over, StopReason why = StopReason::converged) const {
    return is_over ? ended(why) : *this;
  }

  std::size_t moved = 0;  ///< vertices
  SweepStatus status = SweepStatus::running;
  StopReason reason = StopReason::converged;  ///< if converged, why
  std::optional<LevelRecord> level = {};      ///< if it was a step of a level
  bool on_coarse_level = false;               ///< what moved was not the patch itself
  bool in_double = false;  ///< float did not do for a matrix that was to be factored in it
};

/// One pass of a method over all inner vertices. Positions are what counts when it returns: the
/// evolver computes the defects anew.
class Sweep {
 public:
  template <class Pass>
  requires std::is_invocable_r_v<SweepOutcome, Pass> Sweep(
      Pass pass)  // NOLINT(google-explicit-constructor): a pass is all that most methods are
      : pass_(std::move(pass)) {}
  /// @param prolong puts what the method has found on a coarse level into the positions, where it
  /// is
  ///   ended early
  Sweep(std::function<SweepOutcome()> pass, std::function<void()> prolong)
      : pass_(std::move(pass)), prolong_(std::move(prolong)) {}

  SweepOutcome operator()() const { return pass_(); }
  void prolong_to_finest() const {
    if (prolong_) prolong_();
  }

 private:
  std::function<SweepOutcome()> pass_;
  std::function<void()> prolong_;
};

/// One per method, each in the source file of its name. State and pool must outlive the sweep.
Sweep make_sweep(const Auto& options, PatchState& state, ThreadPool& pool);
Sweep make_sweep(const BilaplacianFairing& options, PatchState& state, ThreadPool& pool);
Sweep make_sweep(const ClassicalLaplacian& options, PatchState& state, ThreadPool& pool);
Sweep make_sweep(const ControllableLaplacian& options, PatchState& state, ThreadPool& pool);
Sweep make_sweep(const FlattenableLaplacian& options, PatchState& state, ThreadPool& pool);
Sweep make_sweep(const LeastNorm& options, PatchState& state, ThreadPool& pool);
Sweep make_sweep(const LocalOffset& options, PatchState& state, ThreadPool& pool);
Sweep make_sweep(const GlobalPenalty& options, PatchState& state, ThreadPool& pool);
Sweep make_sweep(const LocalPerturbation& options, PatchState& state, ThreadPool& pool);
Sweep make_sweep(const OwnMethod& method, PatchState& state, ThreadPool& pool);

/// Goes through all visits of the plan, the insides of all pieces at the same time, then each
/// colour of seams: body(begin, end) returns how many of the vertices visited it moved. Returns the
/// total.
std::size_t visit_all(const VisitPlan& plan, ThreadPool& pool,
                      const std::function<std::size_t(std::size_t, std::size_t)>& body);

}  // namespace planish
