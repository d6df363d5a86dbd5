#include "unfold/stretch/bounded_stretch.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/math.h"
#include "core/neumaier_sum.h"
#include "optimize/line_search.h"
#include "unfold/stretch/flat_steps.h"

namespace planish {

namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

/// For the two bounds of an edge: that it may not be too long, and not too short.
struct Pair {
  double longer = 0.0, shorter = 0.0;
};

/// The sum of logarithms of many numbers, with few logarithms.
class LogSum {
 public:
  void add(double x) {
    product_ *= x;
    if (product_ > 1e-100 && product_ < 1e100) return;
    sum_.add(math::log(product_));
    product_ = 1.0;
  }
  double value() const { return sum_.value() + math::log(product_); }

 private:
  NeumaierSum sum_;
  double product_ = 1.0;
};

class BoundedDescent {
 public:
  BoundedDescent(const Disk& disk, StretchSystem& system, std::span<const FlatEdge> edges,
                 std::span<const EdgeBounds> bounds, std::vector<Vec2> start,
                 const BoundedAims& aims)
      : disk_(disk), system_(system), edges_(edges), bounds_(bounds), aims_(aims) {
    for (std::size_t e = 0; e < bounds.size(); ++e) {
      if (bounds[e].longer < k_infinity) bounded_.push_back(e);
    }
    now_.flat = turn_to_axis(disk, std::move(start));
    now_.energy = system_.energy(now_.flat);
    weight_ = aims.weight * now_.energy;
    now_.scale = 1.05 * std::max(largest_share_of_bound(), aims_.least_scale);
    now_.slacks = slacks(now_.flat, now_.scale);
    ends_.reserve(edges_.size());
    for (const FlatEdge& edge : edges_)
      ends_.push_back(system_.pair_of(edge));
    longer_.resize(edges_.size());
    shorter_.resize(edges_.size());
    take_slacks();
    begin_barrier();
  }

  /// False where no step lowers the merit.
  bool step() {
    assemble();
    const auto direction = solve();
    if (!direction) return false;
    const Steps steps = steps_of_slacks(*direction);
    auto trial = search(*direction, steps, longest_share(*direction, steps));
    if (!trial) return false;
    move_multipliers(steps, direction->scale);
    system_.follow(direction->all, trial->share);
    now_ = std::move(trial->state);
    take_slacks();
    lower_barrier(trial->share);
    return true;
  }

  /// About the gap between primal and dual is left to gain. Where that says that the scale cannot
  /// come to where it need not get smaller, it is enough to know it nearly.
  bool is_done() const {
    constexpr double of_merit = 1e-4, of_scale = 5e-3, surely = 1e-3;
    const double scale_to_gain = gap_ / weight_;
    const bool is_above = now_.scale - scale_to_gain > aims_.least_scale + surely;
    if (is_above && scale_to_gain <= of_scale * now_.scale) return true;
    return gap_ <= of_merit * (now_.energy + weight_ * (now_.scale - aims_.least_scale));
  }
  double scale() const { return now_.scale; }
  double energy() const { return now_.energy; }
  std::vector<Vec2> take_flat() { return std::move(now_.flat); }

 private:
  struct State {
    std::vector<Vec2> flat;
    double scale = 1.0, energy = 0.0;
    std::vector<Pair> slacks;
  };
  struct Direction {
    Eigen::VectorXd all;  // of the system's unknowns
    std::vector<Vec2> move;
    double scale = 0.0, slope = 0.0;
  };
  using Steps = std::vector<Pair>;
  struct Trial {
    State state;
    double share = 1.0;
  };

  LaidEdge laid(std::size_t e) const { return {edges_[e], now_.flat}; }

  double largest_share_of_bound() const {
    double largest = 0.0;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const double strain = laid(e).strain;
      const double bound = strain < 0.0 ? bounds_[e].shorter : bounds_[e].longer;
      largest = std::max(largest, std::abs(strain) / bound);
    }
    return largest;
  }

  std::vector<Pair> slacks(const std::vector<Vec2>& flat, double scale) const {
    std::vector<Pair> slacks(edges_.size(), Pair{1.0, 1.0});
    for (const std::size_t e : bounded_) {
      const double strain = LaidEdge(edges_[e], flat).strain;
      slacks[e] = {scale * bounds_[e].longer - strain, scale * bounds_[e].shorter + strain};
    }
    return slacks;
  }

  void take_slacks() {
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      longer_[e].slack = now_.slacks[e].longer;
      shorter_[e].slack = now_.slacks[e].shorter;
    }
    scale_bound_.slack = now_.scale - aims_.least_scale;
  }

  template <class Visit>
  void for_each_bound(Visit visit) {
    for (const std::size_t e : bounded_) {
      visit(longer_[e]);
      visit(shorter_[e]);
    }
    visit(scale_bound_);
  }

  /// At first bounds push the scale back as strongly as the weight pulls.
  void begin_barrier() {
    NeumaierSum push;
    push.add(1.0 / scale_bound_.slack);
    for (const std::size_t e : bounded_) {
      push.add(bounds_[e].longer / longer_[e].slack + bounds_[e].shorter / shorter_[e].slack);
    }
    mu_ = weight_ / push.value();
    for_each_bound([&](Bound& bound) { bound.multiplier = mu_ / bound.slack; });
    merit_ = merit(now_);
  }

  /// E + weight t - mu sum log slack.
  double merit(const State& state) const {
    const double room = state.scale - aims_.least_scale;
    if (!(room > 0.0) || !std::isfinite(state.energy)) return k_infinity;
    LogSum logs;
    logs.add(room);
    for (const Pair& slack : state.slacks) {
      if (!(slack.longer > 0.0) || !(slack.shorter > 0.0)) return k_infinity;
      logs.add(slack.longer);
      logs.add(slack.shorter);
    }
    return state.energy + weight_ * state.scale - mu_ * logs.value();
  }

  void assemble() {
    system_.assemble(now_.flat, Curvature::projected);
    mixed_ = Eigen::VectorXd::Zero(system_.gradient().size());
    NeumaierSum gradient, curvature;
    gradient.add(weight_ - mu_ / scale_bound_.slack);
    curvature.add(scale_bound_.multiplier / scale_bound_.slack);
    for (const std::size_t e : bounded_) {
      const BarrierTerm term(edges_[e], laid(e), bounds_[e], longer_[e], shorter_[e], mu_);
      gradient.add(term.scale);
      curvature.add(term.scale_twice);
      system_.add_to(mixed_, edges_[e], term.mixed);
      system_.add(edges_[e], ends_[e], term.ends);
    }
    scale_gradient_ = gradient.value();
    scale_curvature_ = curvature.value();
  }

  /// The scale is eliminated last: [H, m; m^T, c] [x; t] = -[g; h].
  std::optional<Direction> solve() {
    if (!system_.factor()) return std::nullopt;
    Eigen::MatrixXd right(mixed_.size(), 2);
    right.col(0) = system_.right();
    right.col(1) = mixed_;
    const Eigen::MatrixXd found = system_.solve(right);
    by_scale_ = found.col(1);
    scale_pivot_ = scale_curvature_ - mixed_.dot(by_scale_);
    if (!(scale_pivot_ > 0.0)) return std::nullopt;
    Direction direction = with_scale(found.col(0), -scale_gradient_);
    if (!(direction.slope < 0.0)) return std::nullopt;
    return direction;
  }

  /// @param without what H solves for the right-hand side of the positions
  Direction with_scale(const Eigen::VectorXd& without, double scale_right) const {
    Direction direction;
    direction.scale = (scale_right - mixed_.dot(without)) / scale_pivot_;
    direction.all = without - direction.scale * by_scale_;
    direction.slope = system_.gradient().dot(direction.all) + scale_gradient_ * direction.scale;
    direction.move = system_.spread(direction.all);
    return direction;
  }

  Steps steps_of_slacks(const Direction& direction) const {
    Steps steps(edges_.size());
    for (const std::size_t e : bounded_) {
      const FlatEdge& edge = edges_[e];
      const Vec2 change = direction.move[edge.to] - direction.move[edge.from];
      const double strain = dot(laid(e).along, change) / edge.length;
      steps[e] = {bounds_[e].longer * direction.scale - strain,
                  bounds_[e].shorter * direction.scale + strain};
    }
    return steps;
  }

  /// The step up to 95 % of the way to the next bound, or 90 % of that to the first flip.
  double longest_share(const Direction& direction, const Steps& steps) const {
    double most = first_trial(disk_, now_.flat, direction.move);
    const auto look = [&](double slack, double step) {
      if (step < 0.0) most = std::min(most, -0.95 * slack / step);
    };
    look(scale_bound_.slack, direction.scale);
    for (const std::size_t e : bounded_) {
      look(longer_[e].slack, steps[e].longer);
      look(shorter_[e].slack, steps[e].shorter);
    }
    return most;
  }

  /// Of infinite energy where what the system holds is lost.
  State at(std::vector<Vec2> flat, double scale) const {
    State state;
    auto restored = system_.restored(std::move(flat));
    if (!restored) {
      state.energy = k_infinity;
      return state;
    }
    state.flat = *std::move(restored);
    state.scale = scale;
    state.energy = system_.energy(state.flat);
    state.slacks = slacks(state.flat, state.scale);
    return state;
  }

  /// A trial with a second-order correction: the slacks are brought to where the step saw them,
  /// with the factor of the step. (Edges that turn are longer than the first derivatives say.)
  State corrected(const State& trial, const Steps& steps, double share) const {
    Eigen::VectorXd pull = Eigen::VectorXd::Zero(mixed_.size());
    NeumaierSum scale_pull;
    for (const std::size_t e : bounded_) {
      const double beyond = longer_[e].slack + share * steps[e].longer - trial.slacks[e].longer;
      const double stiff_longer = longer_[e].stiffness(), stiff_shorter = shorter_[e].stiffness();
      const double stiff = (stiff_longer + stiff_shorter) / edges_[e].length;
      system_.add_to(pull, edges_[e], -beyond * stiff * laid(e).along);
      scale_pull.add(bounds_[e].longer * beyond *
                     (stiff_longer - bounds_[e].ratio() * stiff_shorter));
    }
    const Direction more = with_scale(system_.solve(pull), scale_pull.value());
    const double room = first_trial(disk_, trial.flat, more.move);
    return at(moved(trial.flat, room, more.move), trial.scale + room * more.scale);
  }

  std::optional<Trial> search(const Direction& direction, const Steps& steps, double share) const {
    constexpr int most_trials = 30, most_corrected = 3;
    const double rounding = 1e-12 * std::abs(merit_);
    State found;
    const auto lowers = [&](double size, int halvings) {
      const double wanted = merit_ + k_armijo * size * direction.slope + rounding;
      found = at(moved(now_.flat, size, direction.move), now_.scale + size * direction.scale);
      if (merit(found) <= wanted) return true;
      if (halvings >= most_corrected || found.flat.empty()) return false;
      found = corrected(found, steps, size);
      return merit(found) <= wanted;
    };
    const auto taken = backtrack(share, most_trials, lowers);
    if (!taken) return std::nullopt;
    return Trial{std::move(found), taken->size};
  }

  /// By their whole step: lower_barrier() keeps them above 0.
  void move_multipliers(const Steps& steps, double scale_step) {
    const auto move = [&](Bound& bound, double slack_step) {
      bound.multiplier += bound.multiplier_step(mu_, slack_step);
    };
    move(scale_bound_, scale_step);
    for (const std::size_t e : bounded_) {
      move(longer_[e], steps[e].longer);
      move(shorter_[e], steps[e].shorter);
    }
  }

  /// The further the last step went, the more. Multipliers stay near those of the barrier, so that
  /// the matrix stays near that of the merit.
  void lower_barrier(double share) {
    constexpr double apart = 100.0;
    NeumaierSum gap;
    double count = 0.0;
    for_each_bound([&](Bound& bound) {
      const double central = mu_ / bound.slack;
      bound.multiplier = std::clamp(bound.multiplier, central / apart, central * apart);
      gap.add(bound.multiplier * bound.slack);
      count += 1.0;
    });
    gap_ = gap.value();
    const double left = std::clamp((1.0 - share) * (1.0 - share), 0.1, 1.0);
    mu_ = std::min(mu_, left * gap_ / count);
    merit_ = merit(now_);
  }

  const Disk& disk_;
  StretchSystem& system_;
  std::span<const FlatEdge> edges_;
  std::span<const EdgeBounds> bounds_;
  BoundedAims aims_;
  std::vector<std::size_t> bounded_;  // edges that have bounds
  std::vector<BlockMatrix::Pair> ends_;
  State now_;
  std::vector<Bound> longer_, shorter_;
  Bound scale_bound_;
  double weight_ = 0.0, mu_ = 0.0, merit_ = 0.0, gap_ = k_infinity;
  // Derivatives of the merit by the scale: first, second, and mixed with the positions.
  double scale_gradient_ = 0.0, scale_curvature_ = 0.0;
  Eigen::VectorXd mixed_;
  // Of the scale: what a unit of it moves (with a minus sign), and its pivot.
  Eigen::VectorXd by_scale_;
  double scale_pivot_ = 0.0;
};

}  // namespace

BoundedStretch minimise_stretch_within(const Disk& disk, StretchSystem& system,
                                       std::span<const FlatEdge> edges,
                                       std::span<const EdgeBounds> bounds, std::vector<Vec2> start,
                                       const BoundedAims& aims,
                                       const std::function<void()>& after_step) {
  BoundedStretch result;
  BoundedDescent descent(disk, system, edges, bounds, std::move(start), aims);
  while (result.iterations < aims.max_iterations && !result.converged) {
    if (!descent.step()) break;
    ++result.iterations;
    result.converged = descent.is_done();
    if (after_step) after_step();
  }
  result.scale = descent.scale();
  result.flat = descent.take_flat();
  return result;
}

}  // namespace planish
