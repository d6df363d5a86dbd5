// Local flattenable perturbation, section "Local flattenable perturbation" of Wang 2008 with the
// changes of docs/methods/local_perturbation.md: around the worst vertex the smallest step that
// brings all angle sums near it to 2 pi, to first order.

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include <planish/evolve/method.h>

#include "evolve/local_region.h"
#include "evolve/local_step.h"
#include "evolve/sweep.h"
#include "measure/lanes/star_defects.h"
#include "mesh/signed_distance.h"

namespace planish {

namespace {

/// A round takes a vertex at most so often, and so comes to an end.
constexpr unsigned char k_visits = 3;
/// Rounds without a better state after which there is no hope.
constexpr int k_patience = 10;
/// No vertex moves further at once than this share of the smallest height of its triangles. So
/// each of them keeps more than half of its own.
constexpr double k_longest_move = 0.1;

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

/// Works on places of its own; the state gets them whenever they are the best so far.
class LocalPerturber {
 public:
  LocalPerturber(const LocalPerturbation& options, PatchState& state);

  /// Takes the worst vertices until none is worse than half of what the worst was.
  SweepOutcome round();

 private:
  Vec3 position(Index v) const { return {sites_[v].x, sites_[v].y, sites_[v].z}; }
  bool is_inside(Index v) const { return obstacle_ && distance_at(position(v)) < clearance_; }
  double distance_at(Vec3 p) const { return obstacle_->at(p).value; }
  Merit merit() const;
  bool is_done() const {
    return (best_.inside == 0 && best_.e_max <= options_.enough) || idle_rounds_ >= k_patience;
  }

  void take_all_above(double size);
  LocalRegion take(Index center);
  void step(const LocalRegion& region);
  LocalStep problem_of(const LocalRegion& region) const;
  void add_obstacle(const LocalRegion& region, LocalStep& problem) const;
  double longest_move(Index v) const;
  Vec3 target_of(Index v, Vec3 move) const;
  Vec3 away_from_obstacle(Vec3 from, Vec3 target, double longest) const;
  void keep_if_best();

  LocalPerturbation options_;
  PatchState& state_;
  std::vector<std::span<const Index>> rings_;
  std::vector<Site> sites_;
  double clearance_, radius_;
  std::optional<SignedDistance> obstacle_;
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
      clearance_(options.clearance * state.scale()),
      radius_(options.max_deviation * state.scale()) {
  if (!state.obstacle().triangles.empty()) obstacle_.emplace(state.obstacle());
  for (Index v = 0; v < rings_.size(); ++v) {
    if (!state.is_fixed(v) && is_inside(v)) inside_.push_back(v);
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
  if (is_done()) return {0, true};
  const std::vector<Site> before = sites_;
  for (const Index v : inside_) {
    if (is_inside(v)) take(v);
  }
  take_all_above(0.5 * merit().e_max);
  std::erase_if(inside_, [this](Index v) { return !is_inside(v); });
  keep_if_best();
  std::size_t moved = 0;
  for (std::size_t v = 0; v < rings_.size(); ++v)
    moved += before[v].x != sites_[v].x || before[v].y != sites_[v].y || before[v].z != sites_[v].z;
  return {moved, is_done()};
}

void LocalPerturber::take_all_above(double size) {
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
    for (const Index v : take(top.vertex).constrained)
      add(v);
  }
}

LocalRegion LocalPerturber::take(Index center) {
  LocalRegion region = region_around(center, options_.rings, rings_,
                                     [this](Index v) { return !state_.is_fixed(v); });
  for (int i = 0; i < options_.inner_steps && !region.active.empty(); ++i)
    step(region);
  return region;
}

void LocalPerturber::step(const LocalRegion& region) {
  const Eigen::VectorXd solved = options_.damping * problem_of(region).solve();
  std::vector<Vec3> targets;
  for (std::size_t i = 0; i < region.active.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(3 * i);
    targets.push_back(target_of(region.active[i], {solved[at], solved[at + 1], solved[at + 2]}));
  }
  for (std::size_t i = 0; i < targets.size(); ++i) {
    Site& site = sites_[region.active[i]];
    site.x = targets[i].x, site.y = targets[i].y, site.z = targets[i].z;
  }
  for (const Index v : region.constrained) {
    const Star star{rings_[v].data(), v};
    star_defects_(sites_.data(), &star, 1, rings_[v].size(), &sites_[v].defect);
  }
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
  if (obstacle_) add_obstacle(region, problem);
  return problem;
}

/// A row for every vertex that could reach the obstacle: (v + step - h) n >= clearance, h the
/// closest point. In units of the longest move, so that it is about as large as an angle's row.
void LocalPerturber::add_obstacle(const LocalRegion& region, LocalStep& problem) const {
  for (std::size_t i = 0; i < region.active.size(); ++i) {
    const Index v = region.active[i];
    const double reach = longest_move(v) / k_longest_move;
    const Distance distance = obstacle_->at(position(v));
    if (!(reach > 0.0) || distance.value - clearance_ > reach) continue;
    const Eigen::Index row = problem.rows.rows(), column = static_cast<Eigen::Index>(3 * i);
    problem.rows.conservativeResizeLike(Eigen::MatrixXd::Zero(row + 1, problem.rows.cols()));
    problem.sides.conservativeResize(row + 1);
    const Vec3 normal = (1.0 / reach) * distance.gradient;
    problem.rows.row(row).segment<3>(column) << normal.x, normal.y, normal.z;
    problem.sides[row] = (clearance_ - distance.value) / reach;
  }
}

double LocalPerturber::longest_move(Index v) const {
  const auto ring = rings_[v];
  const Vec3 x = position(v);
  double height = std::numeric_limits<double>::infinity();
  Vec3 last = position(ring.back()) - x;
  for (const Index w : ring) {
    const Vec3 next = position(w) - x;
    height = std::min(height, smallest_height(last, next));
    last = next;
  }
  return k_longest_move * height;
}

/// Where a vertex goes that is to move so: as far as it may, and not where it must not be.
Vec3 LocalPerturber::target_of(Index v, Vec3 move) const {
  const Vec3 x = position(v);
  const double longest = longest_move(v), length = norm(move);
  if (!std::isfinite(length)) return x;
  Vec3 target = x + std::min(1.0, length > 0.0 ? longest / length : 1.0) * move;
  if (obstacle_) target = away_from_obstacle(x, target, longest);
  const Interval steps = within_sphere({0.0, 1.0}, x, target - x, state_.origin(v), radius_);
  target = x + steps.high * (target - x);
  if (norm(target - state_.origin(v)) > radius_) return x;
  // Whatever was done before, no vertex gets nearer to the obstacle than it may be.
  if (obstacle_ && distance_at(target) < std::min(clearance_, distance_at(x))) return x;
  return target;
}

/// The target, or if the obstacle is in the way a place beside it, not further from where the
/// vertex is than `longest`.
Vec3 LocalPerturber::away_from_obstacle(Vec3 from, Vec3 target, double longest) const {
  constexpr int k_tries = 4;           // corners have several faces
  const double hair = 1e-6 * longest;  // else rounding would put it inside again
  for (int i = 0; i < k_tries; ++i) {
    const Distance distance = obstacle_->at(target);
    if (distance.value >= clearance_) break;
    target += (clearance_ + hair - distance.value) * distance.gradient;
    const double length = norm(target - from);
    if (length > longest) target = from + (longest / length) * (target - from);
  }
  return target;
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
