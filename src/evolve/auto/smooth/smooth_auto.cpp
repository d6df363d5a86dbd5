#include "evolve/auto/smooth/smooth_auto.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <variant>

#include "core/buffer.h"
#include "evolve/auto/shared/coarse_levels.h"
#include "evolve/auto/shared/defect_polish.h"
#include "evolve/auto/shared/descent_limits.h"
#include "evolve/auto/shared/fairness_energy.h"
#include "evolve/auto/shared/tuning.h"
#include "evolve/auto/smooth/smooth_control.h"
#include "evolve/auto/smooth/smooth_descent.h"
#include "evolve/systems/dense.h"
#include "measure/smoothed.h"

namespace planish {

using namespace tuning::prefer_smooth;

namespace {

StrainLimits limit_of(const Auto& options) {
  if (options.prefer == Prefer::flat) return {.rms = k_nearly_flat};
  const StrainLimits limit = options.limits.of_form();
  return limit.any() ? limit : StrainLimits{.rms = k_unmeasurable_strain};
}

/// Inner vertices of the coarsest level at most.
std::size_t coarsest_of(const Auto& options) {
  const bool careful =
      options.prefer == Prefer::flat || options.max_bending > 0.0 || options.border.moves();
  return careful ? k_coarsest_careful : k_coarsest;
}

/// Of the smooth positions of a level those with the least strain, or with a bound of bending the
/// nearest within the limit.
struct Best {
  double share;      // of the limit, over the strain
  double deviation;  // rms
  Positions positions;
};

// The phases, DefectPolish is the last.

/// How much of the opening of a level is done, as measured on 60,000 and 195,000 vertices.
constexpr double k_level_made = 0.1, k_descent_made = 0.75, k_cost_made = 0.8;

/// No step was made.
struct Untouched {};
/// As little strain as a smooth surface can have, level by level.
struct Smoothing {
  int steps = 0, stagnant_steps = 0;
  std::optional<Best> best = {};
};
/// On to flattenable, as smooth as that can be.
struct Strict {
  int stagnant_steps = 0;
};

class SmoothStepper {
 public:
  SmoothStepper(const Auto& options, PatchState& state, ThreadPool& pool)
      : options_(options),
        limit_(limit_of(options)),
        state_(state),
        pool_(pool),
        least_angle_(angle_to_keep(options, state, pool)),
        levels_(state, coarsest_of(options), state.orbits(), pool),
        level_(levels_.coarsest()) {
    open_level();
    if (descent_->solvable())
      control_.emplace(SmoothControl::Aims{.limit = limit_,
                                           .flat = options.prefer == Prefer::flat,
                                           .max_bending = options.max_bending,
                                           .border_reach = descent_->border_reach()},
                       descent_->strain());
  }

  SweepOutcome step() {
    return std::visit([this](auto& phase) { return step_in(phase); }, phase_);
  }

  /// Brings what coarse levels have found so far to the patch itself.
  void prolong_to_finest() {
    while (level_ > 0)
      lift();
  }

 private:
  SweepOutcome step_in(Untouched& /*phase*/) {
    if (descent_->solvable() && headroom(limit_, descent_->strain()) >= 1.0)
      return of_level().ended(StopReason::strain_met);
    return step_in(phase_.emplace<Smoothing>());
  }

  SweepOutcome step_in(Smoothing& phase) {
    if (!descent_->solvable()) return of_level().ended(StopReason::stalled);
    const SweepOutcome outcome = descend(phase.stagnant_steps);
    keep_best(phase.best);
    const bool over = control_->is_over() || ++phase.steps >= most_steps() ||
                      phase.stagnant_steps >= tuning::k_most_stagnant;
    return over ? end_level(phase, outcome) : outcome;
  }

  SweepOutcome step_in(Strict& phase) {
    const SweepOutcome outcome = descend(phase.stagnant_steps);
    if (!control_->is_over() && phase.stagnant_steps < tuning::k_most_stagnant) return outcome;
    if (!DefectPolish::can_finish(descent_->strain().rms, descent_->jacobian()))
      return outcome.ended(descent_->at_deviation_limit() ? StopReason::deviation_limit
                                                          : StopReason::stalled);
    descent_->release();
    phase_.emplace<DefectPolish>(state_, pool_, limits_on(state_, options_, least_angle_));
    return outcome;
  }

  SweepOutcome step_in(DefectPolish& phase) {
    const DefectPolish::Cycle cycle = phase.cycle();
    SweepOutcome outcome = cycle.moved;
    outcome.in_double = cycle.in_double;
    if (cycle.flat) return outcome.ended(StopReason::converged);
    return outcome.ended_if(cycle.over, phase.held_by().value_or(StopReason::stalled));
  }

  SweepOutcome of_level() const {
    SweepOutcome outcome = SweepOutcome().with(SweepStatus::running);
    outcome.level = {level_state().inner_count()};
    return outcome;
  }

  /// One step on the present level.
  SweepOutcome descend(int& stagnant_steps) {
    const SmoothDescent::Step step = descent_->step(control_->weights());
    control_->after(step, descent_->strain(), descent_->bending(), descent_->deviation());
    stagnant_steps = step.moved > 0 ? 0 : stagnant_steps + 1;
    SweepOutcome outcome = of_level();
    outcome.moved = step.moved;
    outcome.in_double = step.in_double;
    outcome.level = {level_state().inner_count(), step.merit_before, step.merit,
                     descent_->strain().rms};
    outcome.on_coarse_level = level_ > 0;
    return outcome;
  }

  void keep_best(std::optional<Best>& best) const {
    if (!control_->is_smooth()) return;
    const double share = headroom(limit_, descent_->strain());
    const double deviation = descent_->deviation();
    const auto is_better = [&] {
      const bool both_within = std::min(share, best->share) * k_nearly >= 1.0;
      return control_->is_bounded() && both_within ? deviation < best->deviation
                                                   : share > best->share;
    };
    if (!best || is_better()) best = Best{share, deviation, descent_->positions()};
  }

  int most_steps() const {
    if (level_ == levels_.coarsest()) return k_most_first_steps;
    return static_cast<int>(std::clamp(k_later_work / (1 + level_state().inner_count()),
                                       k_least_later_steps, k_most_later_steps));
  }

  SweepOutcome end_level(const Smoothing& phase, const SweepOutcome& outcome) {
    if (phase.best && (control_->is_bounded() || !control_->is_over()))
      descent_->go_to(phase.best->positions);
    if (level_ > 0) {
      lift();
      return outcome;
    }
    if (options_.prefer == Prefer::flat) {
      phase_.emplace<Strict>();
      control_->start_strict();
      return outcome;
    }
    retreat();
    return outcome.ended(reason_to_end());
  }

  StopReason reason_to_end() const {
    if (headroom(limit_, descent_->strain()) * k_nearly >= 1.0) return StopReason::strain_met;
    if (descent_->at_deviation_limit()) return StopReason::deviation_limit;
    if (descent_->at_angle_limit()) return StopReason::angle_limit;
    return StopReason::smooth_limit;
  }

  /// Goes back towards the design until the surface is smooth, or bends as was asked for: by tenths
  /// of the way, then by halves of the last tenth.
  void retreat() {
    const Positions origin = descent_->origin(), away = sum_of(descent_->positions(), -1.0, origin);
    if (!design_) design_.emplace(mesh_at_first(state_));
    const auto is_smooth_at = [&](double share) {
      descent_->go_to(sum_of(origin, share, away));
      std::vector<Vec3> after;
      for (std::size_t v = 0; v < state_.vertex_count(); ++v)
        after.push_back((1.0 / state_.scale()) * state_.position(v));
      pool_.stop_if_cancelled();
      return fairness_beside(*design_, descent_->design_bending(), after)
          .is_smooth_within(options_.max_bending);
    };
    int part = k_retreat_parts;
    while (part > 0 && !is_smooth_at(static_cast<double>(part) / k_retreat_parts))
      --part;
    if (part == k_retreat_parts) return;
    double smooth = static_cast<double>(part) / k_retreat_parts, step = 0.5 / k_retreat_parts,
           last = -1.0;
    for (int halving = 0; halving < k_retreat_halvings; ++halving, step *= 0.5) {
      last = smooth + step;
      if (is_smooth_at(last)) smooth = last;
    }
    if (last != smooth) descent_->go_to(sum_of(origin, smooth, away));
  }

  static bool is_large(const PatchState& state) { return state.inner_count() > k_large; }
  PatchState& level_state() const { return coarse_ ? *coarse_ : state_; }

  void open_level() {
    pool_.report(0.0);
    coarse_ = level_ > 0 ? levels_.make_state(level_, pool_) : nullptr;
    const SmoothMoves moves =
        is_large(level_state()) ? SmoothMoves::along_lines : SmoothMoves::free;
    design_.emplace(mesh_at_first(level_state()));
    pool_.report(k_level_made);
    descent_ = std::make_unique<SmoothDescent>(
        level_state(), pool_, *design_, limits_on(level_state(), options_, least_angle_), moves);
    if (is_dense(level_state().inner_count())) design_.reset();
    pool_.report(k_descent_made);
  }

  /// On to the next finer level.
  void lift() {
    const std::unique_ptr<PatchState> found = std::move(coarse_);
    descent_.reset();  // before the next: it is large
    --level_;
    open_level();
    phase_.emplace<Smoothing>();
    const FairnessEnergy cost(descent_->jacobian(), level_state(), 1.0, descent_->border().bends());
    pool_.report(k_cost_made);
    levels_.lift(level_ + 1, *found, cost, level_state(), pool_);
    if (is_dense(level_state().inner_count())) return_freed_memory();
    descent_->go_to(descent_->positions());
    if (control_) {
      const bool dense_of_large = is_large(state_) && is_dense(level_state().inner_count());
      control_->start_finer(dense_of_large ? k_least_delta_factor_large : k_least_delta_factor);
    }
  }

  Auto options_;
  StrainLimits limit_;
  PatchState& state_;
  ThreadPool& pool_;
  double least_angle_;
  CoarseLevels levels_;
  std::size_t level_;
  std::unique_ptr<PatchState> coarse_;  // of the level, none at the patch itself
  std::optional<Patch> design_;  // the level at first, by its state's numbers; not kept where dense
  std::unique_ptr<SmoothDescent> descent_;
  std::optional<SmoothControl> control_;
  std::variant<Untouched, Smoothing, Strict, DefectPolish> phase_;
};

}  // namespace

Sweep make_smooth_sweep(const Auto& options, PatchState& state, ThreadPool& pool) {
  const auto stepper = std::make_shared<SmoothStepper>(options, state, pool);
  return Sweep([stepper] { return stepper->step(); }, [stepper] { stepper->prolong_to_finest(); });
}

}  // namespace planish
