// Global optimisation of Wang and Tang 2004, with the errata of docs/methods/global_penalty.md: a
// few conjugate-gradient steps on E_s + (rho / 2) G^2, then rho anew.

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include <planish/evolve/method.h>

#include "evolve/methods/penalty_merit.h"
#include "evolve/state/sweep.h"
#include "evolve/systems/positions.h"

namespace planish {

namespace {

/// Share of the fall that the slope promises which a step must bring (Armijo).
constexpr double k_armijo = 1e-4;
constexpr int k_tries = 40;

/// A step must move some vertex by more than rounding does.
constexpr double k_least_move = 1e-15;

/// Defects of this size are rounding: there is nothing to weigh them by.
constexpr double k_no_defect = 1e-12;

double dot(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  NeumaierSum sum;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum.add(planish::dot(a[i], b[i]));
  return sum.value();
}

double largest(const std::vector<Vec3>& a) {
  double size = 0.0;
  for (const Vec3 v : a)
    size = std::max(size, norm(v));
  return size;
}

/// A line through a point with the merit's value and slope there.
struct SearchLine {
  const PenaltyPoint& from;
  const std::vector<Vec3>& direction;  // by node
  double value, slope;
};

class PenaltySolver {
 public:
  PenaltySolver(const GlobalPenalty& options, PatchState& state, ThreadPool& pool)
      : options_(options),
        state_(state),
        merit_(state, options.border, pool),
        at_(merit_.at(all_positions(state))) {
    energy_at_first_ = at_.energy;
  }

  /// One setting of rho.
  SweepOutcome sweep();

 private:
  struct Trial {
    double length, value;
    PenaltyPoint point;
  };

  double value(const PenaltyPoint& point) const {
    return point.stretch + 0.5 * rho_ * point.energy * point.energy;
  }
  std::vector<Vec3> gradient() const { return merit_.gradient(at_, rho_ * at_.energy); }
  Trial try_length(const SearchLine& line, double length) const;
  std::optional<Trial> search(const SearchLine& line, double length) const;
  std::optional<Trial> better_of(const SearchLine& line, Trial trial) const;
  bool counts(const SearchLine& line, const Trial& trial) const {
    return trial.point.sound && trial.value <= line.value + k_armijo * trial.length * line.slope &&
           trial.value < line.value;
  }
  double first_length(const SearchLine& line) const;
  void run_conjugate_gradients();
  std::size_t write_places();

  GlobalPenalty options_;
  PatchState& state_;
  PenaltyMerit merit_;
  PenaltyPoint at_;
  double energy_at_first_ = 0.0;
  double rho_ = 0.0;
  double last_fall_ = 0.0;  // length times slope of the last step
};

PenaltySolver::Trial PenaltySolver::try_length(const SearchLine& line, double length) const {
  std::vector<Vec3> positions = line.from.positions;
  for (std::size_t node = 0; node < merit_.node_count(); ++node) {
    const auto vertices = merit_.vertices_of(node);
    const Vec3 place = positions[vertices.front()] + length * line.direction[node];
    for (const Index v : vertices)
      positions[v] = place;
  }
  PenaltyPoint point = merit_.at(std::move(positions));
  const double merit = value(point);
  return {length, merit, std::move(point)};
}

/// As far as would bring the fall of the last step if the merit went on straight; at first, as far
/// as would bring it to nothing. Never so far that a vertex leaps over its neighbours.
double PenaltySolver::first_length(const SearchLine& line) const {
  const double fall = last_fall_ > 0.0 ? last_fall_ : line.value;
  const double reach = 0.25 * std::sqrt(merit_.mean_squared_edge());
  return std::min(fall / -line.slope, reach / largest(line.direction));
}

std::optional<PenaltySolver::Trial> PenaltySolver::search(const SearchLine& line,
                                                          double length) const {
  const double least = k_least_move / largest(line.direction);
  for (int tries = 0; tries < k_tries && length > least; ++tries) {
    Trial trial = try_length(line, length);
    if (counts(line, trial)) return better_of(line, std::move(trial));
    const double bend = trial.value - line.value - length * line.slope;
    const bool bends = trial.point.sound && bend > 0.0;
    length *= bends ? std::clamp(-length * line.slope / (2.0 * bend), 0.1, 0.5) : 0.25;
  }
  return {};
}

/// The trial or, where that is lower, the minimum of the parabola through it.
std::optional<PenaltySolver::Trial> PenaltySolver::better_of(const SearchLine& line,
                                                             Trial trial) const {
  const double bend = trial.value - line.value - trial.length * line.slope;
  const double promised = -trial.length * line.slope;
  const double share = 8.0 * bend > promised ? promised / (2.0 * bend) : 4.0;
  if (share > 0.8 && share < 1.25) return trial;
  Trial other = try_length(line, share * trial.length);
  return counts(line, other) && other.value < trial.value ? std::move(other) : std::move(trial);
}

/// Polak-Ribiere with restarts: where beta would be negative, where the direction does not lead
/// down, and at every rho, as that changes the merit.
void PenaltySolver::run_conjugate_gradients() {
  std::vector<Vec3> g = gradient(), direction = g;
  for (Vec3& d : direction)
    d = -d;
  for (int step = 0; step < options_.cg_steps; ++step) {
    const double slope = dot(g, direction);
    if (!(slope < 0.0)) return;
    const SearchLine line{at_, direction, value(at_), slope};
    std::optional<Trial> next = search(line, first_length(line));
    if (!next) return;
    last_fall_ = -next->length * slope;
    at_ = std::move(next->point);
    const std::vector<Vec3> before = std::exchange(g, gradient());
    const double squared = dot(g, g);
    const double beta = std::max(0.0, (squared - dot(g, before)) / dot(before, before));
    for (std::size_t i = 0; i < g.size(); ++i)
      direction[i] = beta * direction[i] - g[i];
    if (!(dot(g, direction) < 0.0)) {
      std::transform(g.begin(), g.end(), direction.begin(), [](Vec3 v) { return -v; });
    }
  }
}

std::size_t PenaltySolver::write_places() {
  std::size_t moved = 0;
  for (std::size_t v = 0; v < at_.positions.size(); ++v) {
    if (at_.positions[v] == state_.position(v)) continue;
    state_.move(v, at_.positions[v]);
    ++moved;
  }
  return moved;
}

SweepOutcome PenaltySolver::sweep() {
  const double before = at_.energy;
  if (before <= k_no_defect * k_no_defect * static_cast<double>(state_.inner_count()))
    return SweepOutcome().ended(StopReason::converged);
  rho_ = merit_.mean_squared_edge() / (before * before);
  run_conjugate_gradients();
  const std::size_t moved = write_places();
  const bool still = std::abs(at_.energy - before) <= options_.tolerance * energy_at_first_;
  return SweepOutcome(moved).ended_if(moved > 0 && still);
}

}  // namespace

Sweep make_sweep(const GlobalPenalty& options, PatchState& state, ThreadPool& pool) {
  return [solver = PenaltySolver(options, state, pool)]() mutable { return solver.sweep(); };
}

}  // namespace planish
