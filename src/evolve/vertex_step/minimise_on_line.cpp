// Coleman, Li, An interior trust region approach for nonlinear minimization subject to bounds, SIAM
// J. Optim. 6 (1996), reduced to one variable. In what they call the hat space, where a step is
// divided by D = sqrt(w) and w is the room up to the bound that lies downhill, the model of f is
//   psi(t) = D f' t + (w f'' + |f'|) t^2 / 2,
// Newton's model of w f' = 0, which holds at a minimum inside as well as at one on a bound.

#include "evolve/vertex_step/minimise_on_line.h"

#include <algorithm>
#include <cmath>

namespace planish {

namespace {

constexpr int k_most_evaluations = 100;
constexpr double k_step_tolerance = 1e-9;  // of the interval
constexpr double k_optimality = 1e-13;     // of |f|: what is left to gain up to the bound
constexpr double k_share_of_room = 0.995;  // that a step cut back at the bound takes

class TrustRegion {
 public:
  TrustRegion(const LineFunction& f, Interval interval, double start)
      : f_(f), interval_(interval), best_(look_at(start)) {
    radius_ = std::sqrt(interval.high - interval.low);
  }

  LineMinimum minimise() {
    const double enough = k_step_tolerance * (interval_.high - interval_.low);
    while (evaluations_ < k_most_evaluations) {
      const Model model = model_here();
      if (!(model.room * std::abs(best_.sample.slope) >
            k_optimality * std::abs(best_.sample.value))) {
        break;
      }
      const double step = model.scale * model.best_step(radius_);
      if (std::abs(step) < enough) break;
      const LineMinimum trial = try_step(step, model);
      if (trial.at == best_.at) break;
      take(trial, model);
    }
    best_.evaluations = evaluations_;
    return best_;
  }

 private:
  /// psi at a place.
  struct Model {
    double room, scale;       ///< w and D
    double slope, curvature;  ///< of psi

    double at(double t) const { return t * (slope + 0.5 * curvature * t); }
    /// Where psi is least within the radius.
    double best_step(double radius) const {
      const double newton = curvature > 0.0 ? -slope / curvature : -std::copysign(radius, slope);
      return std::clamp(newton, -radius, radius);
    }
  };

  bool is_inside(double place) const { return place > interval_.low && place < interval_.high; }

  LineMinimum look_at(double place) {
    ++evaluations_;
    return {place, f_(place)};
  }

  Model model_here() const {
    const auto [value, slope, curvature] = best_.sample;
    const double room = slope < 0.0 ? interval_.high - best_.at : best_.at - interval_.low;
    const double scale = std::sqrt(room);
    return {room, scale, scale * slope, room * curvature + std::abs(slope)};
  }

  /// Looks at the end of a step. One that leaves the interval is cut back short of the bound, and
  /// reflected by it: the lower of both counts. (Going down the scaled slope, the third way where
  /// there are more variables, is the first one here.)
  LineMinimum try_step(double step, const Model& model) {
    if (is_inside(best_.at + step)) return look_at(best_.at + step);
    const double cut_back = best_.at + std::copysign(k_share_of_room * model.room, step);
    if (!is_inside(cut_back)) return best_;  // not one number is left up to the bound
    const LineMinimum at_bound = look_at(cut_back);
    const double bound = step > 0.0 ? interval_.high : interval_.low;
    const double reflected = 2.0 * bound - (best_.at + step);
    if (!is_inside(reflected)) return at_bound;
    const LineMinimum behind = look_at(reflected);
    return behind.sample.value < at_bound.sample.value ? behind : at_bound;
  }

  /// Goes to a place that is lower, and fits the radius to how well the model foretold it.
  void take(const LineMinimum& trial, const Model& model) {
    const double step = (trial.at - best_.at) / model.scale;
    const double fall = best_.sample.value - trial.sample.value;
    // psi has a term that f has not.
    const double fall_of_model = fall - 0.5 * std::abs(best_.sample.slope) * step * step;
    const double foretold = -model.at(step);
    const bool is_lower = trial.sample.value < best_.sample.value;
    if (!is_lower || !(fall_of_model > 0.25 * foretold)) {
      radius_ = 0.25 * std::abs(step);
    } else if (fall_of_model > 0.75 * foretold && std::abs(step) > 0.95 * radius_) {
      radius_ *= 2.0;
    }
    if (is_lower) best_ = trial;
  }

  const LineFunction& f_;
  Interval interval_;
  int evaluations_ = 0;
  LineMinimum best_;
  double radius_;
};

}  // namespace

LineMinimum minimise_on_line(const LineFunction& f, Interval interval, double start) {
  return TrustRegion(f, interval, start).minimise();
}

}  // namespace planish
