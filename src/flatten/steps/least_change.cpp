#include "flatten/steps/least_change.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "measure/smoothed.h"

namespace planish {

namespace {

/// Amounts that differ by less are one: going part of the way does the rest.
constexpr double k_near_enough = 0.07;
/// Of the way to the boundary, by which a trial goes beyond it to where the bound holds.
constexpr double k_lean = 0.02;

/// A method ends a little below the limit that it is given: with this one over the strain of the
/// design nothing changes yet.
constexpr double k_idle = 1.06;

bool is_near_enough(double amount, double held) {
  return std::abs(amount - held) <= k_near_enough * held;
}

bool is_kept(const EvolvedPattern& found) {
  return all_kept(found.unfold.limits);
}

const std::vector<Vec3>& positions_of(const EvolvedPattern& found) {
  return found.evolve.result.positions;
}

double move_of(const Patch& design, const EvolvedPattern& found) {
  return measure_deviation(design, positions_of(found)).rms;
}

/// The largest share of the way, from 0 where it holds, at which it still does.
template <class Holds>
double farthest_share(int halvings, const Holds& holds) {
  double good = 0.0, bad = 1.0;
  for (int k = 0; k < halvings; ++k) {
    const double share = 0.5 * (good + bad);
    (holds(share) ? good : bad) = share;
  }
  return good;
}

}  // namespace

BoundarySearch::BoundarySearch(double excess_of_none, double first, double most, int trials)
    : none_{0.0, excess_of_none},
      near_(none_),
      before_last_(none_),
      last_(none_),
      first_(std::min(first, most)),
      most_(most),
      trials_left_(trials) {}

std::optional<double> BoundarySearch::next() const {
  if (trials_left_ == 0) return std::nullopt;
  if (last_.amount == 0.0) return first_;
  if (far_) return between();
  if (near_.amount >= most_) return std::nullopt;
  constexpr double least = 1.25, most = 4.0;
  const double crossing = crossing_of(before_last_, last_).value_or(most_);
  if (none_.holds() && is_near_enough(crossing, near_.amount)) return std::nullopt;
  return std::min(most_, std::clamp(crossing, least * near_.amount, most * near_.amount));
}

/// Where the straight line through both crosses the bound.
std::optional<double> BoundarySearch::crossing_of(const Sample& a, const Sample& b) const {
  const double slope = (b.excess - a.excess) / (b.amount - a.amount);
  const bool is_towards = none_.holds() ? slope > 0.0 : slope < 0.0;
  if (!is_towards) return std::nullopt;
  return b.amount + (1.0 - b.excess) / slope;
}

std::optional<double> BoundarySearch::between() const {
  constexpr double from_ends = 0.1;
  const double width = far_->amount - near_.amount;
  const double held = none_.holds() ? near_.amount : far_->amount;
  double amount = crossing_of(before_last_, last_).value_or(*crossing_of(near_, *far_));
  if (amount <= 0.0) return std::nullopt;
  amount += (none_.holds() ? -k_lean : k_lean) * amount;
  if (is_near_enough(amount, held)) return std::nullopt;
  return std::clamp(amount, near_.amount + from_ends * width, far_->amount - from_ends * width);
}

void BoundarySearch::tell(double amount, double excess) {
  --trials_left_;
  before_last_ = last_;
  last_ = {amount, excess};
  if (last_.holds() == none_.holds())
    near_ = last_;
  else
    far_ = last_;
}

const EdgeStrain& least_strain(const UnfoldReport& report) {
  if (report.unmatched_strain) return *report.unmatched_strain;
  return report.unlimited_strain ? *report.unlimited_strain : report.strain;
}

double headroom(const std::vector<LimitCheck>& checks) {
  double share = std::numeric_limits<double>::infinity();
  for (const LimitCheck& check : checks)
    share = std::min(share, check.limit / check.value);
  return share;
}

std::vector<Vec3> part_way(const std::vector<Vec3>& from, const std::vector<Vec3>& to,
                           double share) {
  std::vector<Vec3> positions = from;
  for (std::size_t v = 0; v < positions.size(); ++v)
    positions[v] = positions[v] + share * (to[v] - positions[v]);
  return positions;
}

namespace {

/// Moves a surface whose pattern keeps the limits back towards the design by bisection.
class WayBack {
 public:
  WayBack(const Patch& design, EvolvedPattern found, const SurfaceRuns& runs)
      : design_(design),
        runs_(runs),
        found_(std::move(found)),
        farthest_(positions_of(found_)),
        may_overlap_(found_.unfold.pattern.overlaps),
        may_bend_(!runs.is_form_good(farthest_)) {}

  void halve(int times) {
    for (int k = 0; k < times; ++k) {
      const double share = 0.5 * (fails_ + keeps_);
      (keeps_at(share) ? keeps_ : fails_) = share;
    }
  }

  /// Of the way from the design, where the surface is now.
  double share() const { return keeps_; }
  const EvolvedPattern& found() const { return found_; }

 private:
  bool keeps_at(double share) {
    const Patch between = design_.with_positions(part_way(design_.positions(), farthest_, share));
    if (!may_bend_ && !runs_.is_form_good(between.positions())) return false;
    UnfoldReport pattern = runs_.unfolded(between);
    if (!all_kept(pattern.limits) || (pattern.pattern.overlaps && !may_overlap_)) return false;
    found_.unfold = std::move(pattern);
    found_.evolve.result.positions = between.positions();
    return true;
  }

  const Patch& design_;
  const SurfaceRuns& runs_;
  EvolvedPattern found_;
  std::vector<Vec3> farthest_;
  bool may_overlap_, may_bend_;
  double fails_ = 0.0, keeps_ = 1.0;
};

}  // namespace

double go_back(const Patch& design, EvolvedPattern& found, const SurfaceRuns& runs) {
  if (!runs.may_be_between || !is_kept(found)) return 1.0;
  WayBack way(design, std::move(found), runs);
  way.halve(runs.effort.halvings);
  found = way.found();
  return way.share();
}

std::optional<EvolvedPattern> least_change(const Patch& design, const UnfoldReport& as_designed,
                                           double design_strain, const SurfaceRuns& runs,
                                           std::optional<double> first_gone) {
  constexpr double unknown = 0.9;  // of what went, where going back is no measure
  const double excess = 1.0 / headroom(as_designed.limits);
  const double idle = k_idle * design_strain, most = idle - k_unmeasurable_strain;
  if (!(excess > 1.0) || !(most > 0.0)) return std::nullopt;
  const double left = first_gone ? design_strain * (1.0 - *first_gone) : design_strain / excess;
  BoundarySearch search(excess, idle - left, most, runs.effort.trials);
  std::optional<WayBack> nearest;
  while (const auto amount = search.next()) {
    EvolvedPattern found = {
        runs.evolved({.rms = idle - *amount}, std::numeric_limits<double>::infinity()), {}};
    found.unfold = runs.unfolded(design.with_positions(positions_of(found)));
    if (!is_kept(found)) {
      if (found.evolve.result.stop != StopReason::strain_met) break;
      search.tell(*amount, 1.0 / headroom(found.unfold.limits));
      continue;
    }
    const double gone = design_strain - least_strain(found.unfold).rms;
    WayBack way(design, std::move(found), runs);
    if (runs.may_be_between) way.halve(runs.effort.first_halvings);
    double enough = unknown;  // as a share
    if (way.share() < 1.0) enough = (design_strain - least_strain(way.found().unfold).rms) / gone;
    search.tell(*amount, std::min(1.0, excess - (excess - 1.0) / enough));
    if (!nearest || move_of(design, way.found()) < move_of(design, nearest->found()))
      nearest.emplace(std::move(way));
  }
  if (!nearest) return std::nullopt;
  if (runs.may_be_between) nearest->halve(runs.effort.last_halvings - runs.effort.first_halvings);
  return nearest->found();
}

Tolerance::Use Tolerance::use(const Patch& design, double bending,
                              const std::vector<Vec3>& after) const {
  const Fairness fairness = fairness_beside(design, bending, after);
  const double fold = fairness.sharpest_fold ? fairness.sharpest_fold->degrees : 0.0;
  constexpr double rounding = 1e-9;
  return {measure_deviation(design, after).max / (distance * (1.0 + rounding)),
          std::max(fold / most_new_fold, fairness.bending_added.value_or(0.0) / most_added)};
}

namespace {

/// Looks for the least strain within a tolerance, in families of surfaces that a limit of strain
/// orders. A surface that goes too far, or folds, is taken back until it may be.
class SearchWithin {
 public:
  SearchWithin(const Patch& design, const Tolerance& tolerance, double design_strain,
               const SurfaceRuns& runs)
      : design_(design),
        tolerance_(tolerance),
        runs_(runs),
        idle_(k_idle * design_strain),
        most_(std::max(idle_ - k_unmeasurable_strain, 0.1 * idle_)) {}

  EvolvedPattern run() {
    // Where a share of strain goes, some place moves by 1.4 times that share of the diagonal.
    constexpr double usual = 0.7, at_first = 0.6, held_goes_on = 1.25;
    const double diagonal = bounding_box_diagonal(design_.mesh());
    const double first = std::min(usual * tolerance_.distance / diagonal, at_first * most_);
    // Free ones fold little, however far they go; those that are held within the tolerance use more
    // of it, and fold where they are.
    search(first, std::numeric_limits<double>::infinity(),
           [](const Tolerance::Use& use) { return use.distance; });
    if (stop_ != StopReason::strain_met)
      search(held_goes_on * (idle_ - best_->unfold.strain.rms), tolerance_.distance,
             [](const Tolerance::Use& use) { return use.most(); });
    best_->evolve.result.stop = stop_ == StopReason::strain_met ? stop_ : end_of_best();
    return std::move(*best_);
  }

 private:
  Tolerance::Use use(const std::vector<Vec3>& positions) const {
    return tolerance_.use(design_, runs_.bending, positions);
  }

  /// What it has most of that it may have.
  StopReason end_of_best() const {
    const Tolerance::Use used = use(positions_of(*best_));
    return used.distance >= used.form ? StopReason::deviation_limit : StopReason::smooth_limit;
  }

  /// In one family.
  template <class Excess>
  void search(double first, double max_deviation, const Excess& excess_of) {
    BoundarySearch amounts(0.0, first, most_, runs_.effort.trials);
    while (const auto amount = amounts.next()) {
      EvolvedPattern found = {runs_.evolved({.rms = idle_ - *amount}, max_deviation), {}};
      const Tolerance::Use whole = use(positions_of(found));
      amounts.tell(*amount, excess_of(whole));
      const bool may_be = whole.most() <= 1.0;
      if (!may_be) take_back(found, whole);
      const StopReason stop = found.evolve.result.stop;
      take_if_better(std::move(found));
      if (may_be && stop != StopReason::strain_met) break;  // it can lose no more
    }
  }

  /// To where it may be.
  void take_back(EvolvedPattern& found, const Tolerance::Use& whole) {
    const std::vector<Vec3> farthest = positions_of(found);
    const auto at = [&](double share) { return part_way(design_.positions(), farthest, share); };
    found.evolve.result.positions = at(farthest_share(runs_.effort.halvings, [&](double share) {
      return runs_.may_be_between && use(at(share)).most() <= 1.0;
    }));
    stop_ = whole.distance >= whole.form ? StopReason::deviation_limit : StopReason::smooth_limit;
  }

  void take_if_better(EvolvedPattern found) {
    found.unfold = runs_.stretched_least(design_.with_positions(positions_of(found)));
    if (!best_ || found.unfold.strain.rms < best_->unfold.strain.rms) best_ = std::move(found);
  }

  const Patch& design_;
  Tolerance tolerance_;
  const SurfaceRuns& runs_;
  double idle_, most_;
  StopReason stop_ = StopReason::strain_met;  // why no more strain could go
  std::optional<EvolvedPattern> best_;
};

}  // namespace

EvolvedPattern least_strain_within(const Patch& design, const Tolerance& tolerance,
                                   double design_strain, const SurfaceRuns& runs) {
  return SearchWithin(design, tolerance, design_strain, runs).run();
}

}  // namespace planish
