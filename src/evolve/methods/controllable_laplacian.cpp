// Controllable Laplacian evolution, Eq. 11-17 of Lin, Zhang, Wang, Gao 2010 with the errata of
// docs/methods/controllable.md: every inner vertex takes the step along its Laplacian vector that
// lowers its ring energy most, and a step is taken only if it lowers it.

#include "evolve/methods/controllable_laplacian.h"

#include <algorithm>
#include <limits>
#include <numbers>

#include "core/math.h"
#include "evolve/state/sweep.h"
#include "evolve/vertex_step/move_by_trust_region.h"

namespace planish {

ControllableMover::ControllableMover(const ControllableLaplacian& options, PatchState& state,
                                     Isa isa)
    : state_(state),
      move_stars_(options.solver == LineSolver::model ? move_stars_for(isa) : move_by_trust_region),
      idle_since_(state.inner_count(), 0) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  // Steps of one sign make no needles by themselves.
  const double limit = options.lambda_min < 0.0 ? options.min_angle * std::numbers::pi / 180.0 : -1;
  options_ = {.lambda_min = options.lambda_min,
              .lambda_max = options.lambda_max,
              .max_cotangent = limit > 0.0 ? 1.0 / math::tan(limit) : inf,
              .radius = options.max_deviation * state.scale(),
              .origins = nullptr};
  if (MoveCheck::is_wanted()) check_.emplace(state);
  if (options_.radius < inf) {
    origins_.assign(state.sites().begin(), state.sites().end());
    options_.origins = origins_.data();
  }
}

std::size_t ControllableMover::move(std::size_t begin, std::size_t end) {
  std::size_t moved = 0;
  const VisitPlan& plan = state_.plan();
  plan.for_runs(begin, end, [&](const Run& run, std::size_t i, std::size_t last) {
    Batch batch;
    for (; i < last; ++i) {
      const Star star = plan.star(run, i);
      if (state_.is_fixed(star.center)) continue;
      const std::uint32_t idle = idle_since_[i];
      if (idle != 0 && !state_.ring_changed_since(idle, star, run.valence)) continue;
      batch.stars[batch.count] = star;
      batch.visits[batch.count] = static_cast<Index>(i);
      if (++batch.count == k_batch) moved += move_batch(batch, run);
    }
    moved += move_batch(batch, run);
  });
  return moved;
}

std::size_t ControllableMover::move_batch(Batch& batch, const Run& run) {
  std::array<unsigned char, k_batch> moved;
  const Changes changes = state_.changes(run.color);
  std::vector<MoveCheck::Energy> before;
  for (std::size_t k = 0; check_ && k < batch.count; ++k)
    before.push_back(check_->energy(batch.stars[k].center));
  move_stars_(options_, state_.sites().data(), changes, batch.stars.data(), batch.count,
              run.valence, moved.data());
  std::size_t total = 0;
  for (std::size_t k = 0; k < batch.count; ++k) {
    idle_since_[batch.visits[k]] = moved[k] != 0 ? 0 : changes.now;
    total += moved[k];
    if (check_ && moved[k] != 0) check_->require_fall(batch.stars[k].center, before[k]);
  }
  batch.count = 0;
  return total;
}

Sweep make_sweep(const ControllableLaplacian& options, PatchState& state, ThreadPool& pool) {
  return [mover = ControllableMover(options, state), &state, &pool]() mutable {
    return SweepOutcome{visit_all(state.plan(), pool, [&](std::size_t begin, std::size_t end) {
      return mover.move(begin, end);
    })};
  };
}

}  // namespace planish
