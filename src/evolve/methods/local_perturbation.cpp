// Local flattenable perturbation, section "Local flattenable perturbation" of Wang 2008 with the
// changes of docs/methods/local_perturbation.md: around the worst vertex the smallest step that
// brings all angle sums near it to 2 pi, to first order.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

#include <planish/evolve/method.h>

#include "evolve/methods/allowed_moves.h"
#include "evolve/methods/local_region.h"
#include "evolve/methods/local_step.h"
#include "evolve/state/sweep.h"
#include "measure/simd/star_defects.h"

namespace planish {

namespace {

/// A round takes a vertex at most so often, and so comes to an end.
constexpr unsigned char k_visits = 3;
/// Rounds without a better state after which there is no hope.
constexpr int k_patience = 10;
/// No vertex moves further at once than this share of the smallest height of its triangles. So
/// each of them keeps more than half of its own.
constexpr double k_longest_move = 0.1;

/// No step may make a defect larger than this multiple of the largest when the round began.
constexpr double k_blow_up = 4.0;
/// What share of the largest eigenvalue an eigenvalue must have to count, and what it must where
/// the step with all of these blows up.
constexpr std::array k_rank_thresholds = {1e-5, 1e-4, 1e-3, 1e-2};

/// The smallest height of the triangle 0, a, b.
double smallest_height(Vec3 a, Vec3 b) {
  const double longest = std::max({norm(a), norm(b), norm(b - a)});
  return longest > 0.0 ? norm(cross(a, b)) / longest : 0.0;
}

/// A vertex that waits to be taken: the largest defect first, of equal ones the smallest number.
struct Waiting {
  double size;
  Index vertex;
  friend bool operator<(const Waiting& a, const Waiting& b) {
    return a.size != b.size ? a.size < b.size : a.vertex > b.vertex;
  }
};

/// How good a state is: what is out of the obstacle counts first, then e_max.
struct Merit {
  std::size_t inside = 0;
  double e_max = 0.0;
  friend bool operator<(const Merit& a, const Merit& b) {
    return a.inside != b.inside ? a.inside < b.inside : a.e_max < b.e_max;
  }
};

/// Works on positions of its own; the state gets them whenever they are the best so far.
class LocalPerturber {
 public:
  LocalPerturber(const LocalPerturbation& options, PatchState& state);

  /// Takes the worst vertices until none is worse than half of what the worst was.
  SweepOutcome round();

 private:
  Vec3 position(Index v) const { return {sites_[v].x, sites_[v].y, sites_[v].z}; }
  Merit merit() const;
  bool is_enough() const { return best_.inside == 0 && best_.e_max <= options_.enough; }

  void take_all_above(double size, double most);
  LocalRegion take(Index center, double most);
  void step(const LocalRegion& region, double most);
  LocalStep problem_of(const LocalRegion& region) const;
  void add_obstacle(const LocalRegion& region, LocalStep& problem) const;
  double smallest_height_at(Index v) const;
  std::vector<Vec3> targets_of(const LocalRegion& region, const Eigen::VectorXd& moves) const;
  void move_to(const LocalRegion& region, const std::vector<Vec3>& targets);
  double worst_of(const LocalRegion& region) const;
  void keep_if_best();

  LocalPerturbation options_;
  PatchState& state_;
  std::vector<std::span<const Index>> rings_;
  std::vector<Site> sites_;
  AllowedMoves allowed_;
  std::vector<Index> inside_;  // the movable vertices that are still too near to the obstacle
  Merit best_;
  int idle_rounds_ = 0;
  StarDefects star_defects_ = star_defects_for(best_isa());
};

LocalPerturber::LocalPerturber(const LocalPerturbation& options, PatchState& state)
    : options_(options),
      state_(state),
      rings_(rings_by_vertex(state.plan())),
      sites_(state.sites().begin(), state.sites().end()),
      allowed_(state, options.clearance * state.scale(), options.max_deviation * state.scale()) {
  for (Index v = 0; v < rings_.size(); ++v) {
    if (!state.is_fixed(v) && allowed_.is_too_near(position(v))) inside_.push_back(v);
  }
  best_ = merit();
}

Merit LocalPerturber::merit() const {
  Merit merit{inside_.size(), 0.0};
  for (Index v = 0; v < rings_.size(); ++v)
    merit.e_max = std::max(merit.e_max, std::abs(sites_[v].defect));
  return merit;
}

SweepOutcome LocalPerturber::round() {
  if (is_enough()) return SweepOutcome().ended(StopReason::converged);
  if (idle_rounds_ >= k_patience) return {};
  const std::vector<Site> before = sites_;
  // To get out is worth any defect.
  for (const Index v : inside_) {
    if (allowed_.is_too_near(position(v))) take(v, std::numeric_limits<double>::infinity());
  }
  const double e_max = merit().e_max;
  take_all_above(0.5 * e_max, k_blow_up * e_max);
  std::erase_if(inside_, [this](Index v) { return !allowed_.is_too_near(position(v)); });
  keep_if_best();
  std::size_t moved = 0;
  for (std::size_t v = 0; v < rings_.size(); ++v)
    moved += before[v].x != sites_[v].x || before[v].y != sites_[v].y || before[v].z != sites_[v].z;
  const SweepOutcome outcome = moved;
  if (is_enough()) return outcome.ended(StopReason::converged);
  return idle_rounds_ < k_patience ? outcome : outcome.with(SweepStatus::stalled);
}

void LocalPerturber::take_all_above(double size, double most) {
  std::vector<unsigned char> visits(rings_.size(), 0);
  std::priority_queue<Waiting> queue;
  const auto add = [&](Index v) {
    const double defect = std::abs(sites_[v].defect);
    if (defect > size && visits[v] < k_visits) queue.push({defect, v});
  };
  for (Index v = 0; v < rings_.size(); ++v)
    add(v);
  while (!queue.empty()) {
    const Waiting top = queue.top();
    queue.pop();
    // Changed since it was put there, and then it is there once more; or taken often enough.
    if (top.size != std::abs(sites_[top.vertex].defect) || visits[top.vertex] >= k_visits) continue;
    ++visits[top.vertex];
    for (const Index v : take(top.vertex, most).constrained)
      add(v);
  }
}

LocalRegion LocalPerturber::take(Index center, double most) {
  LocalRegion region = region_around(center, options_.rings, rings_,
                                     [this](Index v) { return !state_.is_fixed(v); });
  for (int i = 0; i < options_.inner_steps && !region.active.empty(); ++i)
    step(region, most);
  return region;
}

/// One damped step, or a cruder one, or none: no defect gets larger than `most`.
void LocalPerturber::step(const LocalRegion& region, double most) {
  const LocalStep problem = problem_of(region);
  const double bound = std::max(most, worst_of(region));
  std::vector<Vec3> before;
  for (const Index v : region.active)
    before.push_back(position(v));
  for (const double threshold : k_rank_thresholds) {
    move_to(region, targets_of(region, options_.tau * problem.solve(threshold)));
    if (worst_of(region) <= bound) return;
    move_to(region, before);
  }
}

std::vector<Vec3> LocalPerturber::targets_of(const LocalRegion& region,
                                             const Eigen::VectorXd& moves) const {
  std::vector<Vec3> targets;
  for (std::size_t i = 0; i < region.active.size(); ++i) {
    const Index v = region.active[i];
    const auto at = static_cast<Eigen::Index>(3 * i);
    targets.push_back(allowed_.target_of(v, position(v), {moves[at], moves[at + 1], moves[at + 2]},
                                         k_longest_move * smallest_height_at(v)));
  }
  return targets;
}

void LocalPerturber::move_to(const LocalRegion& region, const std::vector<Vec3>& targets) {
  for (std::size_t i = 0; i < targets.size(); ++i) {
    Site& site = sites_[region.active[i]];
    site.x = targets[i].x, site.y = targets[i].y, site.z = targets[i].z;
  }
  for (const Index v : region.constrained) {
    const Star star{rings_[v].data(), v};
    star_defects_(sites_.data(), &star, 1, rings_[v].size(), &sites_[v].defect);
  }
}

double LocalPerturber::worst_of(const LocalRegion& region) const {
  double worst = 0.0;
  for (const Index v : region.constrained)
    worst = std::max(worst, std::abs(sites_[v].defect));
  return worst;
}

LocalStep LocalPerturber::problem_of(const LocalRegion& region) const {
  LocalStep problem;
  problem.rows = angle_rows(region, rings_, sites_);
  problem.equations = problem.rows.rows();
  problem.sides.resize(problem.equations);
  for (Eigen::Index i = 0; i < problem.equations; ++i)
    problem.sides[i] = sites_[region.constrained[static_cast<std::size_t>(i)]].defect;
  problem.pull.resize(problem.rows.cols());
  problem.weights.resize(problem.rows.cols());
  for (std::size_t i = 0; i < region.active.size(); ++i) {
    const Index v = region.active[i];
    const auto at = static_cast<Eigen::Index>(3 * i);
    const Vec3 pull = state_.origin(v) - position(v);
    problem.pull.segment<3>(at) << pull.x, pull.y, pull.z;
    problem.weights.segment<3>(at).setConstant(state_.weight(v));
  }
  add_obstacle(region, problem);
  return problem;
}

/// A row for every vertex that could reach the obstacle: (v + step - h) n >= clearance, h the
/// closest point. In units of the local height, so that it is about as large as an angle's row.
void LocalPerturber::add_obstacle(const LocalRegion& region, LocalStep& problem) const {
  for (std::size_t i = 0; i < region.active.size(); ++i) {
    const Index v = region.active[i];
    const double height = smallest_height_at(v);
    const auto half_space = allowed_.half_space(position(v), height);
    if (!half_space || !(height > 0.0)) continue;
    const Eigen::Index row = problem.rows.rows(), column = static_cast<Eigen::Index>(3 * i);
    problem.rows.conservativeResizeLike(Eigen::MatrixXd::Zero(row + 1, problem.rows.cols()));
    problem.sides.conservativeResize(row + 1);
    const Vec3 normal = (1.0 / height) * half_space->normal;
    problem.rows.row(row).segment<3>(column) << normal.x, normal.y, normal.z;
    problem.sides[row] = half_space->least / height;
  }
}

double LocalPerturber::smallest_height_at(Index v) const {
  const auto ring = rings_[v];
  const Vec3 x = position(v);
  double height = std::numeric_limits<double>::infinity();
  Vec3 last = position(ring.back()) - x;
  for (const Index w : ring) {
    const Vec3 next = position(w) - x;
    height = std::min(height, smallest_height(last, next));
    last = next;
  }
  return height;
}

void LocalPerturber::keep_if_best() {
  ++idle_rounds_;
  const Merit now = merit();
  if (!(now < best_)) return;
  best_ = now;
  idle_rounds_ = 0;
  for (Index v = 0; v < rings_.size(); ++v)
    state_.move(v, position(v));
}

}  // namespace

Sweep make_sweep(const LocalPerturbation& options, PatchState& state, ThreadPool& /*pool*/) {
  return [perturber = LocalPerturber(options, state)]() mutable { return perturber.round(); };
}

}  // namespace planish
