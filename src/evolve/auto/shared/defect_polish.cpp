#include "evolve/auto/shared/defect_polish.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <planish/evolve/method.h>

#include "core/math.h"
#include "evolve/auto/shared/defect_clusters.h"
#include "evolve/auto/shared/fairness_energy.h"
#include "evolve/auto/shared/smallest_angle.h"
#include "evolve/auto/shared/tuning.h"
#include "evolve/state/sweep.h"
#include "evolve/systems/dense.h"
#include "geometry/smallest_angle.h"
#include "solve/sparse_pattern.h"

namespace planish {

using namespace tuning::polish;

namespace {

/// 1/w^2 by inner vertex.
std::vector<double> inverse_weights_of(const PatchState& state) {
  std::vector<double> inverse_weights;
  for (std::size_t v = 0; v < state.inner_count(); ++v)
    inverse_weights.push_back(1.0 / (state.weight(v) * state.weight(v)));
  return inverse_weights;
}

/// The number of neighbours at a vertex, -1 at each that may move too: large on what differs from
/// vertex to vertex, which is what sweeps take out, and as it takes no cotangents, at needles too.
SparseMatrix graph_laplacian(const AngleJacobian& jacobian) {
  const std::size_t n = jacobian.row_count();
  return sparse_matrix(n, n, [&](const auto& add) {
    for (Index v = 0; v < n; ++v) {
      const auto ring = jacobian.ring(v);
      add(v, v, static_cast<double>(ring.size()));
      if (!jacobian.is_movable(v)) continue;
      for (const Index w : ring) {
        if (jacobian.is_movable(w)) add(v, w, -1.0);
      }
    }
  });
}

/// By so much that it counts as flattenable on rounding too.
bool is_surely_flattenable(const Flattenability& figures, const PatchState& state) {
  return figures.e_max <= k_e_max_share * k_flattenable_e_max &&
         figures.sum_abs_defect <= k_defect_sum_share * k_flattenable_sum &&
         holes_close(state.patch(), state.positions_in_mesh_order(), k_defect_sum_share);
}

}  // namespace

DefectPolish::DefectPolish(PatchState& state, ThreadPool& pool, const DescentLimits& limits)
    : state_(state),
      pool_(pool),
      triangles_(state.triangles()),
      limits_(limits),
      inverse_weights_(inverse_weights_of(state)),
      least_(state, inverse_weights_, k_longest_step, pool, step_precision(state.inner_count())),
      damping_rule_(is_dense(state.inner_count()) ? k_damping_dense : k_damping) {
  limits_.angle = std::min(limits_.angle, smallest_angle(state, triangles_, pool));
  const SparseMatrix graph = graph_laplacian(least_.jacobian());
  least_.dual().damp_by(graph * graph, 1.0 / relative_density(state));
}

bool DefectPolish::can_finish(double strain, const AngleJacobian& jacobian) {
  return strain <=
         (jacobian.holes().empty() ? tuning::k_blocked_strain : tuning::k_blocked_strain_of_holes);
}

DefectPolish::Cycle DefectPolish::cycle() {
  const double energy = state_.measure(pool_).energy;
  Cycle cycle{move()};
  const Flattenability figures = state_.measure(pool_);
  cycle.in_double = least_.dual().fell_back();
  cycle.flat = is_surely_flattenable(figures, state_);
  const bool has_step = cycles_++ > 0;
  slow_cycles_ = has_step && figures.energy > k_slow_share * energy ? slow_cycles_ + 1 : 0;
  stalled_cycles_ = figures.energy > k_stalled_share * energy ? stalled_cycles_ + 1 : 0;
  cycle.slow = slow_cycles_;
  cycle.over = cycle.moved == 0 || stalled_cycles_ >= k_most_stalled || cycles_ >= k_most_cycles;
  return cycle;
}

std::size_t DefectPolish::move() {
  const Positions before = inner_positions(state_);
  const double energy = state_.measure(pool_).energy;
  const bool only_sweeps = cycles_ == 0;
  for (int i = 0; i < k_most_dampings; ++i, damping_ *= k_tighten_much) {
    const Positions step = only_sweeps ? Positions(before.size()) : least_norm_step();
    const auto taken = backtrack(1.0, k_most_halvings, [&](double size, int) {
      put(sum_of(before, size, step));
      sweep();
      held_by_.reset();
      keep_limits(before);
      state_.measure(pool_);
      reduce_largest_defects(state_, least_.jacobian(), inverse_weights_, limits_, pool_);
      return state_.measure(pool_).energy < energy;
    });
    if (taken) {
      damping_ = damping_rule_.after(taken, damping_);
      return moved_from(before);
    }
    put(before);
  }
  return 0;
}

std::size_t DefectPolish::moved_from(const Positions& before) const {
  std::size_t moved = 0;
  for (std::size_t v = 0; v < before.size(); ++v)
    moved += state_.position(v) != before[v] ? 1 : 0;
  return moved;
}

Positions DefectPolish::least_norm_step() {
  least_.update();
  if (!least_.factor(damping_)) return Positions(state_.inner_count());
  return least_.stopped(least_.to_close_defects().move(1.0));
}

/// All of them: sweeps move what is held for the matrices' sake too.
void DefectPolish::put(const Positions& positions) {
  for (Index v = 0; v < positions.size(); ++v)
    state_.move(v, positions[v]);
  state_.measure(pool_);
}

void DefectPolish::sweep() {
  const Sweep sweep = make_sweep(ControllableLaplacian{}, state_, pool_);
  for (int i = 0; i < k_sweeps; ++i)
    sweep();
}

void DefectPolish::keep_limits(const Positions& before) {
  stop_at_deviation();
  for (int round = 0; round < k_most_rounds; ++round) {
    const std::vector<Index> sharp = at_sharp_triangles();
    if (sharp.empty()) return;
    held_by_ = StopReason::angle_limit;
    for (const Index v : sharp)
      state_.move(v, before[v]);
  }
  put(before);
}

void DefectPolish::stop_at_deviation() {
  constexpr double rounding = 1e-12;
  for (Index v = 0; v < state_.inner_count(); ++v) {
    const Vec3 away = state_.position(v) - state_.origin(v);
    const double far = norm(away);
    if (far <= limits_.deviation) continue;
    state_.move(v, state_.origin(v) + ((1.0 - rounding) * limits_.deviation / far) * away);
    held_by_ = StopReason::deviation_limit;
  }
}

std::vector<Index> DefectPolish::at_sharp_triangles() const {
  std::vector<unsigned char> sharp(triangles_.size());
  const double cosine = math::cos(limits_.angle);
  pool_.for_ranges(triangles_.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto [a, b, c] = triangles_[t];
      const bool kept = has_smallest_angle_from(limits_.angle, cosine, state_.position(a),
                                                state_.position(b), state_.position(c));
      sharp[t] = kept ? 0 : 1;
    }
  });
  std::vector<Index> vertices;
  for (std::size_t t = 0; t < sharp.size(); ++t) {
    if (sharp[t] == 0) continue;
    std::copy_if(triangles_[t].begin(), triangles_[t].end(), std::back_inserter(vertices),
                 [&](Index v) { return state_.is_inner(v); });
  }
  return vertices;
}

}  // namespace planish
