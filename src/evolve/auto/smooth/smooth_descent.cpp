#include "evolve/auto/smooth/smooth_descent.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <planish/measure/fairness.h>

#include "core/neumaier_sum.h"
#include "evolve/auto/shared/smallest_angle.h"
#include "evolve/auto/shared/tuning.h"
#include "measure/smoothed.h"

namespace planish {

using namespace tuning::prefer_smooth;

namespace {

/// From the middle of the area.
Positions from_middle_of(Positions places, const Eigen::VectorXd& area_shares) {
  const auto mean = [&](double Vec3::*coordinate) {
    NeumaierSum sum;
    for (std::size_t v = 0; v < places.size(); ++v)
      sum.add(area_shares[static_cast<Eigen::Index>(v)] * (places[v].*coordinate));
    return sum.value();
  };
  const Vec3 middle = {mean(&Vec3::x), mean(&Vec3::y), mean(&Vec3::z)};
  for (Vec3& place : places)
    place = place - middle;
  return places;
}

/// The diagonal of a flat rectangle that is as far spread: unlike that of a box it does not depend
/// on how the patch is turned.
double diagonal_of(const Positions& from_middle, const Eigen::VectorXd& area_shares) {
  NeumaierSum sum;
  for (std::size_t v = 0; v < from_middle.size(); ++v)
    sum.add(area_shares[static_cast<Eigen::Index>(v)] * dot(from_middle[v], from_middle[v]));
  return std::sqrt(12.0 * sum.value());
}

/// Of length 1, towards the vertex that is furthest from the middle.
Vec3 long_axis(const Positions& from_middle) {
  const Vec3 furthest = *std::max_element(from_middle.begin(), from_middle.end(),
                                          [](Vec3 a, Vec3 b) { return dot(a, a) < dot(b, b); });
  return (1.0 / norm(furthest)) * furthest;
}

/// A tangent of length 1 across the axis, or any where the normal goes along that.
Vec3 tangent_across(Vec3 axis, Vec3 normal) {
  constexpr double least = 1e-3;
  Vec3 across = cross(normal, axis);
  if (norm(across) < least)
    across = cross(normal, std::abs(normal.x) < 0.5 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0});
  return (1.0 / norm(across)) * across;
}

double bending_to_compare(const Patch& design, const ThreadPool& pool) {
  const double bending = std::max(k_no_bending, design_bending(design));
  pool.stop_if_cancelled();
  return bending;
}

/// Over inner vertices and over those of the border, each the mean.
MoveBarrier barrier_of(const DescentLimits& limits, const BorderMotion& border,
                       std::size_t inner_count) {
  const std::size_t count = border.vertex_count(), of_border = count - inner_count;
  const bool within = limits.border.rule == BorderFreedom::Rule::within;
  const double border_reach =
      within ? std::min(limits.deviation, limits.border.distance) : limits.deviation;
  std::vector<double> reach(count, limits.deviation);
  std::vector<double> counts(count, static_cast<double>(std::max<std::size_t>(inner_count, 1)));
  for (std::size_t v = inner_count; v < count; ++v) {
    reach[v] = border_reach;
    counts[v] = static_cast<double>(of_border);
  }
  return {std::move(reach), std::move(counts)};
}

std::vector<double> weights_of(const PatchState& state, std::size_t count) {
  std::vector<double> weights;
  for (std::size_t v = 0; v < count; ++v)
    weights.push_back(state.weight(v));
  return weights;
}

}  // namespace

SmoothDescent::SmoothDescent(PatchState& state, ThreadPool& pool, const Patch& design,
                             const DescentLimits& limits, SmoothMoves moves)
    : state_(state),
      pool_(pool),
      design_bending_(bending_to_compare(design, pool)),
      limits_(limits),
      along_lines_(moves == SmoothMoves::along_lines),
      border_(limits.border, limits.deviation, state),
      origin_(first_origins(state, state.vertex_count())),
      jacobian_(angle_jacobian_of(state, border_.movable(), hole_borders_of(state))),
      hinges_(design, origin_, design_bending_),
      proximity_(weights_of(state, border_.vertex_count())),
      guard_(state.triangles(), origin_, limits.angle),
      potential_(jacobian_, all_positions(state), pool, BoundaryCondition::free,
                 potential_precision(state.inner_count()), state.orbits()),
      system_(jacobian_, state, pairs_of_terms(), potential_.square(),
              {.inner = along_lines_ ? 1 : 3}, step_precision(state.inner_count()), pool,
              state.orbits()),
      area_shares_(area_shares(guard_.triangles(), origin_)),
      unit_(mean_edge(jacobian_, state)),
      barrier_(barrier_of(limits, border_, state.inner_count())),
      border_bending_(border_.bends(), k_border_bend * unit_) {
  const Positions from_middle = from_middle_of(origin_, area_shares_);
  diagonal_ = diagonal_of(from_middle, area_shares_);
  axis_ = long_axis(from_middle);
  origin_.resize(jacobian_.column_count());
  hinge_pairs_.reserve(6 * hinges_.size());
  for (std::size_t h = 0; h < hinges_.size(); ++h)
    system_.append_pairs(hinges_.stencil(h), hinge_pairs_);
  edge_pairs_.reserve(guard_.edge_count());
  for (std::size_t e = 0; e < guard_.edge_count(); ++e)
    system_.append_pairs(guard_.edge(e), edge_pairs_);
  if (limits_.angle > 0.0)
    limits_.angle = std::min(limits_.angle, smallest_angle(state, guard_.triangles(), pool));
  if (solvable()) renew();
}

KktSystem::ForPairs SmoothDescent::pairs_of_terms() const {
  return [this](const BlockMatrix::VisitPair& visit) {
    const auto visit_all = [&](const auto& vertices) {
      BlockMatrix::for_each_pair(
          vertices.size(), [&](std::size_t i, std::size_t j) { visit(vertices[i], vertices[j]); });
    };
    for (std::size_t h = 0; h < hinges_.size(); ++h)
      visit_all(hinges_.stencil(h));
    for (std::size_t e = 0; e < guard_.edge_count(); ++e)
      visit_all(guard_.edge(e));
    for (const SecondDifference& bend : border_.bends())
      visit_all(bend.vertices);
  };
}

double SmoothDescent::merit(const Eigen::VectorXd& phi) const {
  const Positions x = all_positions(state_), u = moves();
  const double strain = phi.squaredNorm() / static_cast<double>(phi.size());
  return hinges_.value(x, pool_, weights_.form) + proximity_.value(u, weights_.delta * diagonal_) +
         guard_.value(x, pool_) + barrier_.value(u) + border_bending_.value(u) +
         strain / (weights_.sigma * weights_.sigma);
}

/// As of the last measure of the state.
Eigen::VectorXd SmoothDescent::defects() const {
  return potential_.defects(inner_defects(state_), state_.positions());
}

/// K and weights are not renewed.
SmoothDescent::Parts SmoothDescent::at(const Positions& positions) {
  Parts parts;
  if (!std::isfinite(norm_of(positions))) return {std::numeric_limits<double>::infinity(), {}};
  set_positions(positions, jacobian_, state_);
  state_.measure(pool_);
  parts.defects = defects();
  parts.merit = merit(potential_.of(parts.defects, pool_));
  if (!std::isfinite(parts.merit)) parts.merit = std::numeric_limits<double>::infinity();
  return parts;
}

void SmoothDescent::renew() {
  state_.measure(pool_);
  const Positions x = all_positions(state_);
  potential_.update(x, pool_);
  if (!potential_.solvable()) return;
  hinges_.set_weights(x, pool_);
  phi_ = potential_.of(defects(), pool_);
  strain_ = {edge_strain_of(std::sqrt(phi_.cwiseAbs2().dot(area_shares_))),
             phi_.cwiseAbs().maxCoeff()};
  bending_ = hinges_.value(x, pool_);
}

void SmoothDescent::go_to(const Positions& positions) {
  set_positions(within_limits(positions), jacobian_, state_);
  renew();
}

double SmoothDescent::deviation() const {
  NeumaierSum away;
  for (const Vec3 move : moves())
    away.add(dot(move, move));
  return std::sqrt(away.value()) / (std::sqrt(static_cast<double>(origin_.size())) * diagonal_);
}

std::optional<double> SmoothDescent::border_reach() const {
  if (!limits_.border.moves()) return {};
  if (limits_.border.rule == BorderFreedom::Rule::slide) return 0.0;
  return std::min(limits_.border.distance, limits_.deviation) / diagonal_;
}

/// Of the inner vertices the normals, or tangents along the patch or across it. Where triangles
/// cancel, any will do.
Positions SmoothDescent::lines(MoveDirection direction) const {
  Positions lines;
  for (Index v = 0; v < state_.inner_count(); ++v) {
    const Vec3 at_v = normal_at(v, jacobian_, state_),
               normal = dot(at_v, at_v) > 0.0 ? at_v : Vec3{0.0, 0.0, 1.0},
               across = tangent_across(axis_, normal);
    lines.push_back(direction == MoveDirection::normal      ? normal
                    : direction == MoveDirection::tangent_u ? cross(across, normal)
                                                            : across);
  }
  return lines;
}

/// Of F without phi.
/// @param force minus the gradient
void SmoothDescent::assemble(std::optional<MoveDirection> direction, Positions& force) {
  system_.clear(direction ? lines(*direction) : Positions{});
  assemble_shape(force);
  assemble_moves(force);
}

/// Of hinges, edges and corners.
void SmoothDescent::assemble_shape(Positions& force) {
  const Positions x = all_positions(state_);
  const auto add = [&](const auto& part, auto... pairs) {
    system_.add_term(part.vertices, pairs..., (1.0 + stiffening_) * part.second, part.gradient);
    for (std::size_t k = 0; k < part.vertices.size(); ++k) {
      if (part.vertices[k] < force.size())
        force[part.vertices[k]] += -part.first * part.gradient[k];
    }
  };
  for (std::size_t h = 0; h < hinges_.size(); ++h)
    add(hinges_.summand(h, x, weights_.form), hinge_pairs_.data() + 6 * h);
  for (std::size_t e = 0; e < guard_.edge_count(); ++e)
    add(guard_.edge_summand(e, x), edge_pairs_.data() + e);
  for (std::size_t c = 0; c < guard_.corner_count(); ++c) {
    if (const Summand<3> part = guard_.corner_summand(c, x); part.second != 0.0) add(part);
  }
}

/// What pulls vertices to where they were, slows them near their limits, holds them along the
/// surface, or the border where they slide, and keeps moves of the border smooth.
void SmoothDescent::assemble_moves(Positions& force) {
  const double stiff = 1.0 + stiffening_, delta = weights_.delta * diagonal_;
  const double slide =
      stiff * 2.0 /
      (static_cast<double>(origin_.size()) * (k_slide * diagonal_) * (k_slide * diagonal_));
  const double off_curve = k_off_curve * slide;
  const Positions u = moves();
  for (Index v = 0; v < u.size(); ++v) {
    const bool inner = state_.is_inner(v), slides = !inner && border_.direction_count() == 1;
    const double pull = proximity_.stiffness(v, delta);
    force[v] += -pull * u[v];
    const double own = stiff * pull, held = slides ? off_curve : slide;
    // Where a border moves freely, it is held in all directions alike.
    const Vec3 n = inner    ? normal_at(v, jacobian_, state_)
                   : slides ? border_.direction(v, 0)
                            : Vec3{};
    system_.add_vertex(
        v, {own + held * (1.0 - n.x * n.x), -held * n.x * n.y, -held * n.x * n.z,
            own + held * (1.0 - n.y * n.y), -held * n.y * n.z, own + held * (1.0 - n.z * n.z)});
    const MoveBarrier::Derivatives part = barrier_.derivatives(v, u[v], stiff);
    force[v] += -1.0 * part.gradient;
    system_.add_vertex(v, part.hessian);
  }
  for (const SecondDifference& difference : border_bending_.differences()) {
    for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
      system_.add_term(difference.vertices, stiff * border_bending_.stiffness(),
                       difference.gradient(axis));
    const std::array<Vec3, 3> gradient = border_bending_.gradient(difference, u);
    for (std::size_t k = 0; k < 3; ++k) {
      if (difference.vertices[k] < force.size()) force[difference.vertices[k]] += -gradient[k];
    }
  }
}

/// The nearest positions that limits of distance, the rule of the border and symmetry allow.
Positions SmoothDescent::within_limits(Positions positions) const {
  border_.restrict(positions);
  return symmetric_about(
      origin_, state_.orbits(),
      within_distance(std::move(positions), origin_, state_.inner_count(), limits_.deviation));
}

bool SmoothDescent::angles_hold() {
  return !(limits_.angle > 0.0) ||
         smallest_angle(state_, guard_.triangles(), pool_) >= limits_.angle;
}

/// No vertex goes further than the longest step.
Positions SmoothDescent::shortened(Positions step) const {
  double longest = 0.0;
  for (const Vec3 move : step)
    longest = std::max(longest, norm(move));
  const double most = k_longest_step * unit_;
  if (longest <= most) return step;
  for (Vec3& move : step)
    move = (most / longest) * move;
  return step;
}

/// A share of the full step, and where `corrected` what a second solve makes of it, if that is
/// better: that takes back by how much the defects miss what their Jacobian predicted.
SmoothDescent::Trial SmoothDescent::try_step(const Positions& before,
                                             const Eigen::VectorXd& defects, const Positions& full,
                                             double share, bool corrected) {
  Trial plain;
  plain.positions = within_limits(sum_of(before, share, full));
  plain.parts = at(plain.positions);
  if (!corrected || !std::isfinite(plain.parts.merit)) return plain;
  const Eigen::VectorXd missed = plain.parts.defects - defects + share * jacobian_.times(full);
  Trial better;
  better.positions = within_limits(
      sum_of(plain.positions, 1.0, system_.solve(Positions(before.size()), -missed, pool_)));
  better.parts = at(better.positions);
  return better.parts.merit < plain.parts.merit ? better : plain;
}

/// Most memory is needed while a factor is made. On large levels there is no other one meanwhile:
/// that of K K^T is made again afterwards.
bool SmoothDescent::factor_system(double c) {
  if (along_lines_) potential_.release();
  const bool factored = system_.factor(potential_.square(), c, pool_);
  if (along_lines_) potential_.factor(pool_);
  return factored;
}

SmoothDescent::Step SmoothDescent::step(const SmoothWeights& weights) {
  weights_ = weights;
  if (!along_lines_) return step_along({});
  Step result = step_along(MoveDirection::normal);
  for (const MoveDirection direction : {MoveDirection::tangent_u, MoveDirection::tangent_v}) {
    const Step part = step_along(direction);
    result.moved = std::max(result.moved, part.moved);
    result.merit -= part.merit_before - part.merit;
    result.in_double = result.in_double || part.in_double;
    ++result.parts;
  }
  return result;
}

/// Along lines, or freely.
SmoothDescent::Step SmoothDescent::step_along(std::optional<MoveDirection> direction) {
  const Positions before = positions();
  Step result;
  result.merit = result.merit_before = merit(phi_);
  jacobian_.update(state_.positions(), pool_);
  Positions force(before.size());
  assemble(direction, force);
  const double c = 0.5 * static_cast<double>(phi_.size()) * weights_.sigma * weights_.sigma;
  if (!factor_system(c)) return result;
  const Eigen::VectorXd at_first = defects();
  const Positions full = shortened(system_.solve(force, -at_first, pool_));
  at_angle_limit_ = false;
  const auto taken = backtrack(1.0, tuning::k_most_halvings, [&](double size, int halvings) {
    const Trial trial = try_step(before, at_first, full, size, halvings < k_corrected_trials);
    if (!(trial.parts.merit < result.merit_before)) return false;
    set_positions(trial.positions, jacobian_, state_);
    if (!angles_hold()) {
      at_angle_limit_ = true;
      return false;
    }
    result.merit = trial.parts.merit;
    for (std::size_t v = 0; v < before.size(); ++v)
      result.moved += trial.positions[v] != before[v] ? 1 : 0;
    return true;
  });
  result.in_double = system_.fell_back();
  if (result.moved == 0) set_positions(before, jacobian_, state_);
  if (along_lines_) system_.release();
  renew();
  at_deviation_limit_ = barrier_.is_reached(moves());
  stiffening_ = k_damping.after(taken, stiffening_);
  return result;
}

}  // namespace planish
