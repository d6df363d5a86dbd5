// From coarse to fine, each level by StrainDescent, the last defects by polishing. Equations
// and what was tried: docs/methods/auto.md.

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include <planish/evolve/method.h>
#include <planish/measure/flattenability.h>

#include "core/buffer.h"
#include "evolve/auto/near/deviation_reduction.h"
#include "evolve/auto/near/strain_descent.h"
#include "evolve/auto/shared/coarse_levels.h"
#include "evolve/auto/shared/defect_polish.h"
#include "evolve/auto/shared/tuning.h"
#include "evolve/auto/smooth/smooth_auto.h"
#include "evolve/state/sweep.h"
#include "evolve/systems/dense.h"

namespace planish {

namespace {

using namespace tuning::prefer_near;

/// The place of least strain since vertices came to the limit of deviation.
struct BestAtLimit {
  double strain;
  Positions positions;
  int steps;  // since then
};

/// The first phase of a level: strain is taken out of it. DeviationReduction, where a limit of
/// strain is met, and DefectPolish, on the patch itself, are the others.
struct Descending {
  int steps = 0, stagnant_steps = 0;
  std::optional<BestAtLimit> best_at_limit = {};
};

class AutoStepper {
 public:
  AutoStepper(const Auto& options, PatchState& state, ThreadPool& pool)
      : options_(options),
        state_(state),
        pool_(pool),
        least_angle_(angle_to_keep(options, state, pool)),
        // Of the whole: on halves some patches end twice as far from the design.
        levels_(state, k_coarsest, {}, pool),
        level_(levels_.coarsest()) {
    open_level();
    descent_->start(k_cold_start);
  }

  SweepOutcome step() {
    return std::visit([this](auto& phase) { return step_in(phase); }, phase_);
  }

  /// Brings what coarse levels have found so far to the patch itself.
  void prolong_to_finest() {
    finish_reduction();
    while (level_ > 0)
      lift();
  }

 private:
  /// Makes the descent of the level, its patch where it was at first.
  /// @param closeness of the coarser level, if there was one
  void open_level(double closeness = 0.0) {
    coarse_ = level_ > 0 ? levels_.make_state(level_, pool_) : nullptr;
    descent_ = std::make_unique<StrainDescent>(
        level_state(), pool_,
        DescentAims{strain_limit(), options_.closeness, closeness, allowance_exponent_}, limits());
    if (is_dense(level_state().inner_count())) return_freed_memory();
  }

  StrainLimits strain_limit() const { return options_.limits.of_form(); }

  PatchState& level_state() const { return coarse_ ? *coarse_ : state_; }

  DescentLimits limits() const { return limits_on(level_state(), options_, least_angle_); }

  /// On to the next finer level.
  void lift() {
    const std::unique_ptr<PatchState> found = std::move(coarse_);
    const double closeness = descent_->closeness(), sigma = descent_->sigma();
    const bool was_met = descent_->strain_is_met();
    phase_.emplace<Descending>();
    descent_.reset();  // before the next: it is large
    --level_;
    open_level(closeness);
    levels_.lift(level_ + 1, *found, descent_->cost(), level_state(), pool_);
    descent_->start(k_warm_start);
    // What lifting broke of the limit is mended without going far beyond it.
    if (was_met) descent_->track_strain_limit(sigma);
    if (was_met && descent_->strain_is_met()) phase_.emplace<DeviationReduction>(*descent_);
  }

  SweepOutcome step_in(Descending& phase) {
    SweepOutcome outcome = of_level();
    if (!descent_->solvable() || descent_->strain_is_met()) return end_level(outcome);
    const double strain_before = descent_->rms_strain();
    const StrainDescent::Step step = descent_->step();
    outcome = of_level(step);
    if (descent_->strain_is_met()) {
      phase_.emplace<DeviationReduction>(*descent_);
      return outcome;
    }
    return is_over(phase, step, strain_before) ? end_level(outcome) : outcome;
  }

  SweepOutcome step_in(DeviationReduction& phase) {
    if (!descent_->solvable()) return end_level(of_level());
    const SweepOutcome outcome = of_level(phase.step());
    return phase.over() ? end_level(outcome) : outcome;
  }

  /// Of a step on the present level.
  SweepOutcome of_level() const {
    SweepOutcome outcome = SweepOutcome().with(SweepStatus::running);
    outcome.level = {level_state().inner_count()};
    outcome.on_coarse_level = level_ > 0;
    return outcome;
  }

  SweepOutcome of_level(const StrainDescent::Step& step) const {
    SweepOutcome outcome = of_level();
    outcome.moved = step.moved;
    outcome.in_double = step.in_double;
    outcome.level = {level_state().inner_count(), step.merit_before, step.merit,
                     descent_->rms_strain()};
    return outcome;
  }

  /// True if the step was the last of the level.
  bool is_over(Descending& phase, const StrainDescent::Step& step, double strain_before) {
    const bool held = is_held(phase.best_at_limit);
    phase.stagnant_steps = step.moved > 0 ? 0 : phase.stagnant_steps + 1;
    const bool over = held || is_done(strain_before) ||
                      phase.stagnant_steps >= tuning::k_most_stagnant ||
                      ++phase.steps >= most_steps();
    const auto& best = phase.best_at_limit;
    const bool was_less = best && best->strain < descent_->rms_strain();
    if (held || (over && was_less)) descent_->go_to(best->positions);
    return over;
  }

  /// True where hardly any strain is left. On the patch itself polishing does the rest, which takes
  /// fewer cycles the less there is: so quick steps go on.
  bool is_done(double strain_before) const {
    const double strain = descent_->rms_strain();
    const bool slow = strain > k_quick_fall * strain_before;
    return strain <= k_level_strain || (level_ == 0 && slow && strain <= k_polish_strain);
  }

  /// True where vertices are at the limit of deviation and strain hardly falls any more: what goes
  /// on there only crumples.
  bool is_held(std::optional<BestAtLimit>& best) const {
    if (!descent_->at_deviation_limit()) return false;
    const bool less = !best || descent_->rms_strain() < k_gain_at_limit * best->strain;
    if (less && (!best || !descent_->is_too_rough()))
      best = BestAtLimit{descent_->rms_strain(), descent_->positions(), -1};
    return ++best->steps >= k_most_at_limit;
  }

  int most_steps() const {
    if (blocked_by_boundary_) return k_blocked_steps;
    return level_ == levels_.coarsest() ? k_most_first_steps : k_most_steps;
  }

  /// What comes after a level: the next one, polishing, or the end.
  SweepOutcome end_level(SweepOutcome outcome) {
    finish_reduction();
    blocked_by_boundary_ =
        !descent_->strain_is_met() && descent_->rms_strain() > tuning::k_blocked_strain;
    const bool may_try = tries_ < k_most_tries && rounds_ == 0 && level_ == levels_.coarsest();
    if (may_try && !blocked_by_boundary_ && descent_->is_too_rough()) {
      start_smoother();
    } else if (level_ > 0) {
      lift();
    } else if (const auto reason = reason_to_end()) {
      outcome = outcome.ended(*reason);
    } else {
      strain_at_end_ = descent_->rms_strain();
      descent_->release();
      phase_.emplace<DefectPolish>(state_, pool_, limits());
    }
    outcome.on_coarse_level = level_ > 0;
    return outcome;
  }

  void finish_reduction() {
    if (auto* reduction = std::get_if<DeviationReduction>(&phase_)) reduction->finish();
    phase_.emplace<Descending>();
  }

  /// The coarsest level once more, from where the vertices were at first.
  void start_smoother() {
    ++tries_;
    allowance_exponent_ *= k_exponent_decay;
    descent_->go_to(descent_->cost().origin());
    open_level();
    descent_->start(k_cold_start);
  }

  std::optional<StopReason> reason_to_end() const {
    if (descent_->strain_is_met()) return StopReason::strain_met;
    const bool nearly_flat = descent_->rms_strain() <= k_polish_strain;
    if (descent_->at_deviation_limit() && !nearly_flat) return StopReason::deviation_limit;
    if (DefectPolish::can_finish(descent_->rms_strain(), descent_->jacobian())) return {};
    return descent_->at_angle_limit() ? StopReason::angle_limit : StopReason::stalled;
  }

  SweepOutcome step_in(DefectPolish& phase) {
    const DefectPolish::Cycle cycle = phase.cycle();
    SweepOutcome outcome = cycle.moved;
    outcome.in_double = cycle.in_double;
    if (limit_is_met_after_all()) {
      phase_.emplace<DeviationReduction>(*descent_);
      return outcome.with(SweepStatus::running);
    }
    if (cycle.flat) return outcome.ended(StopReason::converged);
    // A descent that was given up would hardly do better again, so cycles go on for longer.
    const bool soon = cycle.slow >= k_slow_cycles && strain_at_end_ <= k_polish_strain;
    if ((cycle.over || soon) && rounds_++ < k_most_rounds) {
      phase_.emplace<Descending>();
      descent_->start(k_warm_start);
      return outcome.with(SweepStatus::running);
    }
    return outcome.ended_if(cycle.over, phase.held_by().value_or(StopReason::stalled));
  }

  /// Steps may stall at single vertices before they come to a limit of strain. Cycles mend those;
  /// then what is near is looked for as usual.
  bool limit_is_met_after_all() {
    if (!strain_limit().any()) return false;
    descent_->go_to(descent_->positions());
    return descent_->strain_is_met();
  }

  Auto options_;
  PatchState& state_;
  ThreadPool& pool_;
  double least_angle_;
  CoarseLevels levels_;
  std::size_t level_;
  std::unique_ptr<PatchState> coarse_;  // of the level, none at the patch itself
  std::unique_ptr<StrainDescent> descent_;
  std::variant<Descending, DeviationReduction, DefectPolish> phase_;
  int tries_ = 1, rounds_ = 0;       // on the coarsest level; of polishing
  double allowance_exponent_ = 1.0;  // of the usual one
  double strain_at_end_ = 0.0;       // of the last descent on the patch itself
  bool blocked_by_boundary_ = false;
};

}  // namespace

Sweep make_sweep(const Auto& options, PatchState& state, ThreadPool& pool) {
  if (options.prefer != Prefer::near) return make_smooth_sweep(options, state, pool);
  const auto stepper = std::make_shared<AutoStepper>(options, state, pool);
  return Sweep([stepper] { return stepper->step(); }, [stepper] { stepper->prolong_to_finest(); });
}

}  // namespace planish
