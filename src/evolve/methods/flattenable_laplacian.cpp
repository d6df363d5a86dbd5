// Flattenable Laplacian mesh: C. C. L. Wang, "Towards flattenable mesh surfaces", Computer-Aided
// Design 40 (2008), with a symmetric matrix. Equations in docs/methods/flattenable_laplacian.md.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

#include <planish/evolve/method.h>

#include "evolve/state/sweep.h"
#include "evolve/systems/kkt_system.h"
#include "evolve/systems/positions.h"
#include "solve/sparse_pattern.h"

namespace planish {

namespace {

/// Rows of the printed matrix times |N(p)| over the mean valence, which makes it symmetric.
SparseMatrix hessian_of(const FlattenableLaplacian& options, const PatchState& state,
                        const std::vector<double>& shares) {
  const auto rings = rings_by_vertex(state.plan());
  return sparse_matrix(rings.size(), rings.size(), [&](const auto& add) {
    for (Index v = 0; v < rings.size(); ++v) {
      const double stay = options.position * state.weight(v) * state.weight(v);
      add(v, v, shares[v] * (options.fairness + stay));
      const double pull = options.fairness * shares[v] / static_cast<double>(rings[v].size());
      for (const Index w : rings[v]) {
        if (w > v && state.is_inner(w)) add(w, v, -pull);
      }
    }
  });
}

/// |N(p)| over its mean.
std::vector<double> valence_shares(const PatchState& state) {
  std::vector<double> shares;
  double sum = 0.0;
  for (const auto ring : rings_by_vertex(state.plan())) {
    shares.push_back(static_cast<double>(ring.size()));
    sum += shares.back();
  }
  for (double& share : shares)
    share *= static_cast<double>(shares.size()) / sum;
  return shares;
}

class FlattenableStepper {
 public:
  FlattenableStepper(const FlattenableLaplacian& options, PatchState& state, ThreadPool& pool)
      : options_(options),
        state_(state),
        pool_(pool),
        jacobian_(angle_jacobian_of(state)),
        shares_(valence_shares(state)),
        hessian_(hessian_of(options, state, shares_)),
        identity_(hessian_.rows(), hessian_.cols()),
        base_(inner_positions(state)) {
    identity_.setIdentity();
    const auto for_pairs = [this](const BlockMatrix::VisitPair& visit) {
      for_entries_of(hessian_, [&](Index v, Index w, double) { visit(v, w); });
    };
    system_.emplace(jacobian_, state, for_pairs, identity_, KktSystem::Moves{}, Precision::full,
                    pool);
    for_entries_of(hessian_, [this](Index v, Index w, double) {
      system_->append_pairs(std::array{v, w}, pairs_);
    });
  }

  SweepOutcome step() {
    state_.measure(pool_);
    jacobian_.update(state_.positions(), pool_);
    if (options_.rebase_every > 0 && steps_ % options_.rebase_every == 0)
      base_ = inner_positions(state_);
    ++steps_;
    if (!factor()) return {};
    const Positions step = stopped(system_->solve(forces(), -inner_defects(state_), pool_));
    const std::size_t moved =
        set_positions(sum_of(inner_positions(state_), options_.tau, step), jacobian_, state_);
    const double rms = norm_of(step) / std::sqrt(static_cast<double>(step.size()));
    return SweepOutcome(moved).ended_if(rms <= options_.min_step * mean_edge(jacobian_, state_));
  }

 private:
  /// Damping is a share of the mean of the squares of the Jacobian's rows.
  bool factor() {
    double squares = 0.0;
    for (Index v = 0; v < jacobian_.row_count(); ++v) {
      for (const AngleJacobian::Entry& entry : jacobian_.column(v)) {
        const Vec3 gradient = jacobian_.gradient(entry.entry);
        squares += dot(gradient, gradient);
      }
    }
    const double mean = squares / static_cast<double>(jacobian_.row_count());
    if (!(mean > 0.0)) return false;
    system_->clear();
    const BlockMatrix::Pair* pair = pairs_.data();
    for_entries_of(hessian_, [&](Index v, Index w, double value) {
      system_->add_scalar(v, w, *pair++, 1.0, value);
    });
    return system_->factor(identity_, options_.damping * mean, pool_);
  }

  /// Minus the gradient of what is made small: towards the mean of the ring and towards the base.
  Positions forces() const {
    Positions forces(base_.size());
    for (Index v = 0; v < forces.size(); ++v) {
      const auto ring = jacobian_.ring(v);
      const Vec3 x = state_.position(v);
      Vec3 umbrella;
      for (const Index w : ring)
        umbrella += (1.0 / static_cast<double>(ring.size())) * (state_.position(w) - x);
      const double stay = options_.position * state_.weight(v) * state_.weight(v);
      forces[v] = shares_[v] * (options_.fairness * umbrella + stay * (base_[v] - x));
    }
    return forces;
  }

  /// No vertex by more than the mean length of its edges: where A is nearly singular it would fly
  /// off.
  Positions stopped(Positions step) const {
    for (Index v = 0; v < step.size(); ++v) {
      const double length = norm(step[v]), most = edges_at(v, jacobian_, state_).mean;
      if (length > most) step[v] = (most / length) * step[v];
    }
    return step;
  }

  FlattenableLaplacian options_;
  PatchState& state_;
  ThreadPool& pool_;
  AngleJacobian jacobian_;
  std::vector<double> shares_;
  SparseMatrix hessian_, identity_;
  std::optional<KktSystem> system_;
  std::vector<BlockMatrix::Pair> pairs_;  // of the entries of the hessian
  Positions base_;
  int steps_ = 0;
};

}  // namespace

Sweep make_sweep(const FlattenableLaplacian& options, PatchState& state, ThreadPool& pool) {
  const auto stepper = std::make_shared<FlattenableStepper>(options, state, pool);
  return [stepper] { return stepper->step(); };
}

}  // namespace planish
