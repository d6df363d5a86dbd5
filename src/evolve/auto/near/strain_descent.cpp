#include "evolve/auto/near/strain_descent.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/neumaier_sum.h"
#include "evolve/auto/shared/smallest_angle.h"
#include "solve/sparse_pattern.h"

namespace planish {

using namespace tuning::prefer_near;

namespace {

/// |phi|^2 is a sum over vertices: on denser patches the same strain weighs more. Sigma goes along.
double sigma_unit(const PatchState& state) {
  return std::sqrt(relative_density(state));
}

/// True if the descent is to come as near as a limit of strain allows. Vertices held at a limit of
/// deviation need a way around them that is smooth.
bool stays_near(const DescentAims& aims, const DescentLimits& limits) {
  return aims.strain.any() && std::isinf(limits.deviation);
}

/// Holes close only where phi may differ from 0 at their borders.
BoundaryCondition pattern_border(const DescentAims& aims, const AngleJacobian& jacobian) {
  return aims.strain.any() || !jacobian.holes().empty() ? BoundaryCondition::free
                                                        : BoundaryCondition::dirichlet;
}

/// Where nearly all strain has to go, a border that is nearly held leads there by a shorter way,
/// and what it may stretch hardly counts any more.
/// @param stays share of the strain at first
double ease_for(double stays) {
  const double share = std::min(1.0, stays / k_much_strain);
  return std::max(k_least_ease, share * share);
}

/// @param stays share of the strain at first
ClosenessPace pace_for(const DescentAims& aims, const DescentLimits& limits, double stays,
                       double density) {
  ClosenessPace schedule = k_usual_closeness;
  if (stays_near(aims, limits)) {
    schedule.allowance_exponent = k_earliness_near;
    schedule.most = k_most_near * std::max(1.0, density * density);
    // Where little strain has to go, crumples may take it up at once.
    schedule.first = std::max(schedule.first, k_first_near * stays * stays);
  }
  // Much room is not filled by weights that are right for a little.
  const double room = std::clamp(aims.room, 1.0, k_most_room);
  schedule.most *= room * room;
  schedule.allowance_exponent *= aims.allowance_exponent;
  return schedule;
}

}  // namespace

StrainDescent::StrainDescent(PatchState& state, ThreadPool& pool, const DescentAims& aims,
                             const DescentLimits& limits)
    : state_(state),
      pool_(pool),
      aims_(aims),
      limits_(limits),
      triangles_(state.triangles()),
      border_(limits.border, limits.deviation, state),
      jacobian_(angle_jacobian_of(state, border_.movable(), hole_borders_of(state))),
      potential_(jacobian_, all_positions(state), pool, pattern_border(aims, jacobian_),
                 potential_precision(state.inner_count())),
      phi_(potential_.solvable() ? potential_.of(defects(), pool) : Eigen::VectorXd()),
      area_shares_(area_shares(triangles_, first_origins(state, state.vertex_count()))),
      at_first_(strain_now()),
      stays_(std::min(1.0, headroom(aims.strain, at_first_))),
      pace_(pace_for(aims, limits, stays_, relative_density(state))),
      control_(state, aims.room, pace_),
      closeness_(aims.closeness > 0.0 ? aims.closeness : pace_.first),
      cost_(jacobian_, state, closeness_, border_.bends()),
      system_(jacobian_, state, pairs_of_cost(), potential_.square(),
              {.inner = 1, .border = border_.direction_count()},
              step_precision(state.inner_count()), pool),
      relaxation_(jacobian_, state) {
  for_entries_of(cost_.hessian(), [this](Index v, Index w, double) {
    system_.append_pairs(std::array{v, w}, cost_pairs_);
  });
  if (potential_.border() == BoundaryCondition::free) {
    potential_.set_boundary_compliance(ease_for(aims.strain.any() ? stays_ : 0.0));
    potential_.update(all_positions(state), pool);
  }
  if (limits_.angle > 0.0)
    limits_.angle = std::min(limits_.angle, smallest_angle(state, triangles_, pool));
}

void StrainDescent::start(const StepSchedule& schedule) {
  if (!solvable()) return;
  const Positions away = sum_of(positions(), -1.0, cost_.origin());
  for (double share = 1.0; share > k_least_start; share *= 0.5) {
    set_positions(within_limits(sum_of(cost_.origin(), share, away)), jacobian_, state_);
    if (angles_hold_after_slides()) break;
  }
  update_strain();
  sigma_ = std::min(1.0, schedule.sigma_per_strain * strain_.rms) * sigma_unit(state_);
  least_sigma_ = k_least_sigma * sigma_unit(state_);
  sigma_ = std::max(sigma_, least_sigma_);
  longest_step_ = schedule.longest_step * cost_.unit();
  fall_of_sigma_ = schedule.fall_of_sigma;
  stiffening_ = 0.0;
  tracks_limit_ = false;
}

double StrainDescent::sigma() const {
  return sigma_ / sigma_unit(state_);
}

void StrainDescent::track_strain_limit(double sigma) {
  tracks_limit_ = true;
  sigma_ = sigma * sigma_unit(state_);
}

/// As of the last measure of the state.
Eigen::VectorXd StrainDescent::defects() const {
  return potential_.defects(inner_defects(state_), state_.positions());
}

void StrainDescent::update_strain() {
  state_.measure(pool_);
  // With K of the initial surface the estimate can be gamed: steps then lower it without lowering
  // the strain of the pattern. So K follows the surface.
  if (potential_.border() == BoundaryCondition::free)
    potential_.update(all_positions(state_), pool_);
  if (potential_.solvable())
    phi_ = potential_.of(defects(), pool_);
  else
    phi_.setConstant(std::numeric_limits<double>::infinity());  // no step ends there
  strain_ = strain_now();
}

DescentStrain StrainDescent::strain_now() const {
  if (phi_.size() == 0) return {};
  const double most = phi_.cwiseAbs().maxCoeff();
  if (potential_.border() == BoundaryCondition::dirichlet) {
    return {phi_.norm() / std::sqrt(static_cast<double>(phi_.size())), most};
  }
  return {edge_strain_of(std::sqrt(phi_.cwiseAbs2().dot(area_shares_))), most};
}

double StrainDescent::merit() const {
  return cost_.value(positions()) + 0.5 * phi_.squaredNorm() / (sigma_ * sigma_);
}

double StrainDescent::merit_at(const Positions& x) {
  if (!std::isfinite(norm_of(x))) return std::numeric_limits<double>::infinity();
  set_positions(x, jacobian_, state_);
  update_strain();
  return merit();
}

KktSystem::ForPairs StrainDescent::pairs_of_cost() const {
  return [this](const BlockMatrix::VisitPair& visit) {
    for_entries_of(cost_.hessian(), [&](Index v, Index w, double) { visit(v, w); });
  };
}

/// The normals of the inner vertices, then what the border's slide along.
std::vector<Vec3> StrainDescent::directions() const {
  std::vector<Vec3> directions;
  for (Index v = 0; v < border_.vertex_count(); ++v) {
    if (state_.is_inner(v))
      directions.push_back(normal_at(v, jacobian_, state_));
    else if (border_.direction_count() == 1)
      directions.push_back(border_.direction(v, 0));
  }
  return directions;
}

Positions StrainDescent::newton_step() {
  jacobian_.update(state_.positions(), pool_);
  const Positions x = positions(), force = sum_of(Positions(x.size()), -1.0, cost_.gradient(x));
  system_.clear(directions(), cost_.unit());
  const BlockMatrix::Pair* pair = cost_pairs_.data();
  for_entries_of(cost_.hessian(), [&](Index v, Index w, double value) {
    system_.add_scalar(v, w, *pair++, 1.0 + stiffening_, value);
  });
  if (!system_.factor(potential_.square(), sigma_ * sigma_, pool_)) return Positions(x.size());
  return system_.solve(force, -defects(), pool_);
}

Positions StrainDescent::within_limits(Positions x) const {
  border_.restrict(x);
  return within_distance(std::move(x), cost_.origin(), state_.inner_count(), limits_.deviation);
}

/// Tells the cost which vertices cannot go on, so that the next step finds another way.
void StrainDescent::hold_far_vertices() {
  cost_.scale_proximity(border_.at_limit(), k_heavier_border);
  if (std::isinf(limits_.deviation)) return;
  std::vector<Index> far;
  for (Index v = 0; v < state_.inner_count(); ++v) {
    if (norm(state_.position(v) - cost_.origin()[v]) >= tuning::k_at_limit * limits_.deviation)
      far.push_back(v);
  }
  cost_.scale_proximity(far, k_heavier);
  deviation_stopped_ = deviation_stopped_ || !far.empty();
}

/// Slides make angles hold if only a few did not.
bool StrainDescent::angles_hold_after_slides() {
  for (int i = 0; i < k_most_slides && !angles_hold(); ++i) {
    if (relaxation_.relax() == 0) break;
    set_positions(within_limits(positions()), jacobian_, state_);
  }
  return angles_hold();
}

bool StrainDescent::angles_hold() {
  return !(limits_.angle > 0.0) || smallest_angle(state_, triangles_, pool_) >= limits_.angle;
}

StrainDescent::Step StrainDescent::step() {
  const Positions& x = before_ = positions();
  Step result;
  result.merit_before = result.merit = merit();
  const Positions newton = newton_step();
  double longest = 0.0;
  for (const Vec3 s : newton)
    longest = std::max(longest, norm(s));
  const double first = longest > longest_step_ ? longest_step_ / longest : 1.0;
  angle_stopped_ = false;
  const auto taken = backtrack(first, tuning::k_most_halvings, [&](double size, int) {
    const double merit = merit_at(within_limits(sum_of(x, size, newton)));
    if (!(merit < result.merit_before)) return false;
    if (relaxation_.relax() > 0) {
      set_positions(within_limits(positions()), jacobian_, state_);
      update_strain();
    }
    if (!angles_hold()) {
      angle_stopped_ = true;
      return false;
    }
    result.merit = merit;
    for (std::size_t v = 0; v < x.size(); ++v)
      result.moved += state_.position(v) != x[v] ? 1 : 0;
    return true;
  });
  result.in_double = system_.fell_back();
  if (result.moved == 0) go_to(before_);
  stiffening_ = k_damping.after(taken, stiffening_);
  sigma_ = next_sigma(taken ? taken->size : 0.0, result);
  update_proximity_weight();
  hold_far_vertices();
  return result;
}

void StrainDescent::go_to(const Positions& positions) {
  set_positions(positions, jacobian_, state_);
  update_strain();
}

double StrainDescent::deviation() const {
  const double away = norm_of(sum_of(positions(), -1.0, cost_.origin()));
  return away / std::sqrt(static_cast<double>(border_.vertex_count()));
}

double StrainDescent::next_sigma(double share, const Step& step) const {
  if (tracks_limit_) {
    if (step.moved == 0) return k_failed * sigma_;
    const double room = headroom(aims_.strain, strain_);
    return std::clamp(room < 1.0 ? room : std::sqrt(room), 1.0 / k_most_fall, k_most_growth) *
           sigma_;
  }
  const double least_per_strain =
      strain_.rms > k_large_strain ? k_least_per_large_strain : k_least_per_strain;
  const double least = std::max(least_sigma_, least_per_strain * strain_.rms * sigma_unit(state_));
  if (step.moved == 0) return std::max(k_failed * sigma_, least);
  const bool full = share > k_full_step;
  const bool settled = step.merit_before - step.merit < k_small_fall * step.merit_before;
  if (full || settled) return std::max(fall_of_sigma_ * sigma_, least);
  return std::max(share > k_far_enough ? k_slow * sigma_ : sigma_, least);
}

/// What is left, rms: down to where it is expected once the strain is at its limit. The largest
/// itself comes and goes from step to step.
double StrainDescent::strain_to_go() const {
  const double share = aims_.strain.any() ? stays_ : 0.0;
  return std::max(0.0, strain_.rms - share * at_first_.rms);
}

/// Lets the next step stay closer where there is room for roughness, or be smoother.
void StrainDescent::update_proximity_weight() {
  const bool on_the_way = !tracks_limit_, was_found = aims_.closeness > 0.0;
  const double strain_left = on_the_way && !was_found ? strain_to_go() : 0.0;
  double next = control_.after_step(closeness_, strain_left, stiffening_ < k_stiff);
  if (on_the_way && was_found) next = std::min(next, closeness_);
  cost_.scale_closeness(next / closeness_);
  // Between closeness and strain the balance is sigma's.
  if (tracks_limit_) sigma_ *= std::sqrt(closeness_ / next);
  closeness_ = next;
}

}  // namespace planish
