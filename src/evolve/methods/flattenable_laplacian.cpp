// Flattenable Laplacian mesh: C. C. L. Wang, "Towards flattenable mesh surfaces", Computer-Aided
// Design 40 (2008), with a symmetric matrix, and constraints that get softer where e_max would
// rise. Equations in docs/methods/flattenable_laplacian.md.

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

/// Where e_max would rise, the constraints are made softer by this factor, up to the softest; where
/// it fell, harder again.
constexpr double k_softer = 10.0, k_softest = 0.1;

/// With the softest constraints the step is halved this often instead.
constexpr int k_shorter = 6;

/// Up to here e_max may rise if it began higher, in radians: what is flattenable is left to slide
/// along the constraints.
constexpr double k_closed = 1e-4;

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
    const double e_max = state_.measure(pool_).e_max;
    if (steps_ == 0) allowed_ = std::min(e_max, k_closed);
    jacobian_.update(state_.positions(), pool_);
    if (options_.rebase_every > 0 && steps_ % options_.rebase_every == 0)
      base_ = inner_positions(state_);
    ++steps_;
    const Positions before = inner_positions(state_), force = forces();
    const Eigen::VectorXd closing = -inner_defects(state_);
    const double most = std::max(e_max, allowed_);
    for (double softness = softness_;; softness = std::min(k_softer * softness, k_softest)) {
      const bool is_softest = softness >= k_softest;
      if (const auto step = solved(force, closing, softness)) {
        double share = options_.tau * clamp_of(*step);
        for (int halving = 0; halving <= (is_softest ? k_shorter : 0); ++halving, share *= 0.5) {
          const std::size_t moved = set_positions(sum_of(before, share, *step), jacobian_, state_);
          if (!(state_.measure(pool_).e_max <= most)) continue;
          softness_ = std::max(options_.damping, softness / k_softer);
          return SweepOutcome(moved).ended_if(is_short(*step));
        }
      }
      if (is_softest) break;
    }
    set_positions(before, jacobian_, state_);
    return {};
  }

 private:
  /// None where the system has no solution in numbers.
  std::optional<Positions> solved(const Positions& force, const Eigen::VectorXd& closing,
                                  double softness) {
    if (!factor(softness)) return {};
    Positions step = system_->solve(force, closing, pool_);
    if (!std::isfinite(norm_of(step))) return {};
    return step;
  }

  /// Damping is a share of the mean of the squares of the Jacobian's rows.
  bool factor(double softness) {
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
    return system_->factor(identity_, softness * mean, pool_);
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

  /// The share of a step that moves no vertex by more than the mean length of its edges: where A is
  /// nearly singular it would fly off. All of it is scaled, as the constraints hold for it whole.
  double clamp_of(const Positions& step) const {
    double share = 1.0;
    for (Index v = 0; v < step.size(); ++v)
      share = std::min(share, edges_at(v, jacobian_, state_).mean / norm(step[v]));
    return share;
  }

  bool is_short(const Positions& step) const {
    const double rms = norm_of(step) / std::sqrt(static_cast<double>(step.size()));
    return rms <= options_.min_step * mean_edge(jacobian_, state_);
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
  double softness_ = options_.damping;
  double allowed_ = 0.0;  // e_max up to which it may rise
};

}  // namespace

Sweep make_sweep(const FlattenableLaplacian& options, PatchState& state, ThreadPool& pool) {
  const auto stepper = std::make_shared<FlattenableStepper>(options, state, pool);
  return [stepper] { return stepper->step(); };
}

}  // namespace planish
