// From coarse to fine, each level by StrainDescent, the last defects by polishing. Equations
// and what was tried: docs/methods/auto.md.

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include <planish/evolve/method.h>
#include <planish/measure/flattenability.h>

#include "evolve/auto/deviation_reduction.h"
#include "evolve/auto/strain_descent.h"
#include "evolve/descent/coarse_levels.h"
#include "evolve/descent/defect_polish.h"
#include "evolve/descent/tuning.h"
#include "evolve/smooth/smooth_auto.h"
#include "evolve/state/sweep.h"

namespace planish {

namespace {

using namespace tuning::prefer_near;

class AutoStepper {
 public:
  AutoStepper(const Auto& options, PatchState& state, ThreadPool& pool)
      : options_(options),
        state_(state),
        pool_(pool),
        least_angle_(angle_to_keep(options, state, pool)),
        levels_(state, k_coarsest),
        level_(levels_.coarsest()) {
    open_level();
    descent_->start(k_cold_start);
  }

  SweepOutcome step() { return polish_ ? polish() : descend(); }

  /// Brings what coarse levels have found so far to the patch itself.
  void prolong_to_finest() {
    if (reduction_) reduction_->finish();
    reduction_.reset();
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
    steps_ = stagnant_steps_ = 0;
    best_at_limit_.reset();
  }

  StrainLimit strain_limit() const { return {options_.max_strain, options_.max_rms_strain}; }

  PatchState& level_state() const { return coarse_ ? *coarse_ : state_; }

  DescentLimits limits() const { return limits_on(level_state(), options_, least_angle_); }

  /// On to the next finer level.
  void lift() {
    const std::unique_ptr<PatchState> found = std::move(coarse_);
    const double closeness = descent_->closeness(), sigma = descent_->sigma();
    const bool was_met = descent_->strain_is_met();
    reduction_.reset();
    descent_.reset();  // before the next: it is large
    --level_;
    open_level(closeness);
    levels_.lift(level_ + 1, *found, descent_->cost(), level_state(), pool_);
    descent_->start(k_warm_start);
    // What lifting broke of the limit is mended without going far beyond it.
    if (was_met) descent_->track_strain_limit(sigma);
    if (was_met && descent_->strain_is_met()) reduction_.emplace(*descent_);
  }

  SweepOutcome descend() {
    SweepOutcome outcome = SweepOutcome().with(SweepStatus::running);
    if (!descent_->solvable() || (!reduction_ && descent_->strain_is_met())) {
      outcome.level = {level_state().inner_count()};
    } else if (const bool over = descent_step(outcome); !over) {
      outcome.on_coarse_level = level_ > 0;
      return outcome;
    }
    end_level(outcome);
    outcome.on_coarse_level = level_ > 0;
    return outcome;
  }

  /// @return true if it was the last of the level
  bool descent_step(SweepOutcome& outcome) {
    const StrainDescent::Step step = reduction_ ? reduction_->step() : descent_->step();
    outcome.moved = step.moved;
    outcome.in_double = step.in_double;
    outcome.level = {level_state().inner_count(), step.merit_before, step.merit,
                     descent_->rms_strain()};
    if (reduction_) return reduction_->over();
    if (descent_->strain_is_met()) {
      reduction_.emplace(*descent_);
      return false;
    }
    const bool held = is_held();
    stagnant_steps_ = step.moved > 0 ? 0 : stagnant_steps_ + 1;
    const double enough = level_ > 0 ? k_coarse_strain : k_polish_strain;
    const bool over = held || descent_->rms_strain() <= enough ||
                      stagnant_steps_ >= tuning::k_most_stagnant || ++steps_ >= most_steps();
    const bool was_less = best_at_limit_ && best_at_limit_->strain < descent_->rms_strain();
    if (held || (over && was_less)) descent_->go_to(best_at_limit_->positions);
    return over;
  }

  /// True where vertices are at the limit of deviation and strain hardly falls any more: what goes
  /// on there only crumples.
  bool is_held() {
    if (!descent_->at_deviation_limit()) return false;
    const bool less =
        !best_at_limit_ || descent_->rms_strain() < k_gain_at_limit * best_at_limit_->strain;
    if (less && (!best_at_limit_ || !descent_->is_too_rough()))
      best_at_limit_ = BestAtLimit{descent_->rms_strain(), descent_->positions(), -1};
    return ++best_at_limit_->steps >= k_most_at_limit;
  }

  int most_steps() const {
    if (blocked_by_boundary_) return k_blocked_steps;
    return level_ == levels_.coarsest() ? k_most_first_steps : k_most_steps;
  }

  /// What comes after a level: the next one, polishing, or the end.
  void end_level(SweepOutcome& outcome) {
    if (reduction_) reduction_->finish();
    reduction_.reset();
    blocked_by_boundary_ =
        !descent_->strain_is_met() && descent_->rms_strain() > tuning::k_blocked_strain;
    const bool may_try = tries_ < k_most_tries && rounds_ == 0 && level_ == levels_.coarsest();
    if (may_try && !blocked_by_boundary_ && descent_->is_too_rough()) return start_smoother();
    if (level_ > 0) return lift();
    const auto reason = reason_to_end();
    if (reason) {
      outcome = outcome.ended(*reason);
      return;
    }
    descent_->release();
    polish_.emplace(state_, pool_, limits());
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
    if (!blocked_by_boundary_) return std::nullopt;
    return descent_->at_angle_limit() ? StopReason::angle_limit : StopReason::stalled;
  }

  SweepOutcome polish() {
    const DefectPolish::Cycle cycle = polish_->cycle();
    SweepOutcome outcome = cycle.moved;
    outcome.in_double = cycle.in_double;
    if (limit_is_met_after_all()) return outcome.with(SweepStatus::running);
    if (cycle.flat) return outcome.ended(StopReason::converged);
    if (cycle.over && rounds_++ < k_most_rounds) {
      descend_again();
      return outcome.with(SweepStatus::running);
    }
    return outcome.ended_if(cycle.over, polish_->held_by().value_or(StopReason::stalled));
  }

  /// Steps may stall at single vertices before they come to a limit of strain. Cycles mend those;
  /// then what is near is looked for as usual.
  bool limit_is_met_after_all() {
    if (!strain_limit().given()) return false;
    descent_->go_to(descent_->positions());
    if (!descent_->strain_is_met()) return false;
    polish_.reset();
    reduction_.emplace(*descent_);
    return true;
  }

  void descend_again() {
    polish_.reset();
    descent_->start(k_warm_start);
    steps_ = stagnant_steps_ = 0;
    best_at_limit_.reset();
  }

  Auto options_;
  PatchState& state_;
  ThreadPool& pool_;
  double least_angle_;
  CoarseLevels levels_;
  std::size_t level_;
  std::unique_ptr<PatchState> coarse_;  // of the level, none at the patch itself
  std::unique_ptr<StrainDescent> descent_;
  std::optional<DeviationReduction> reduction_;
  std::optional<DefectPolish> polish_;
  /// The place of least strain since vertices came to the limit of deviation.
  struct BestAtLimit {
    double strain;
    Positions positions;
    int steps;  // since then
  };
  std::optional<BestAtLimit> best_at_limit_;
  int tries_ = 1, steps_ = 0, stagnant_steps_ = 0, rounds_ = 0;
  double allowance_exponent_ = 1.0;  // of the usual one
  bool blocked_by_boundary_ = false;
};

}  // namespace

Sweep make_sweep(const Auto& options, PatchState& state, ThreadPool& pool) {
  if (options.prefer != Prefer::near) return make_smooth_sweep(options, state, pool);
  const auto stepper = std::make_shared<AutoStepper>(options, state, pool);
  return Sweep([stepper] { return stepper->step(); }, [stepper] { stepper->prolong_to_finest(); });
}

}  // namespace planish
