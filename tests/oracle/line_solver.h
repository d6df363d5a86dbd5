#pragma once

#include <algorithm>
#include <cmath>

#include "evolve/vertex_step/interval.h"

namespace planish {

/// A function of one variable at one place: its value, slope and an estimate of its second
/// derivative that is not negative (Gauss-Newton: twice the sum of the squared slopes of the
/// residuals).
struct LinePoint {
  double at = 0.0, value = 0.0, slope = 0.0, curvature = 0.0;
};

/// Goes downhill from 0 to a minimum of f on the interval by two Gauss-Newton steps and then secant
/// steps of the slope, kept inside a
/// bracket that shrinks at every evaluation: a step that would leave it, or not lower f, is
/// replaced by its middle. Converges from any start; at most k_most_evaluations calls.
/// @param f double -> LinePoint
/// @pre interval.low <= 0 <= interval.high
/// @return where the least value was seen; 0 where f rises both ways
template <class F>
LinePoint minimise_on_line(const F& f, Interval interval) {
  constexpr int k_most_evaluations = 16;
  constexpr double k_tolerance = 1e-3;  // b is flat at its minimum
  LinePoint best = f(0.0), other = best;
  const bool upward = best.slope < 0.0;
  // The minimum lies between inner (tried) and outer (tried only where `outer_tried`).
  double inner = 0.0, outer = upward ? interval.high : interval.low;
  bool outer_tried = false;
  if (best.slope == 0.0 || outer == 0.0) return best;
  const double enough = k_tolerance * std::min(1.0, interval.high - interval.low);
  for (int evaluations = 1; evaluations < k_most_evaluations; ++evaluations) {
    double bend = best.curvature;
    if (evaluations > 2) {  // the secant of the slope
      const double rise = (best.slope - other.slope) / (best.at - other.at);
      if (rise > 0.0) bend = rise;
    }
    double next = bend > 0.0 ? best.at - best.slope / bend : outer;
    const auto [low, high] = std::minmax(inner, outer);
    if (!(next > low && next < high)) {
      const bool beyond_outer = upward ? next >= outer : next <= outer;
      next = beyond_outer && !outer_tried ? outer : 0.5 * (inner + outer);
    }
    if (std::abs(next - best.at) < enough) break;
    const LinePoint point = f(next);
    const bool downhill_outward = upward ? point.slope < 0.0 : point.slope > 0.0;
    other = point.value < best.value ? best : point;
    if (point.value < best.value) {
      best = point;
      if (downhill_outward) {
        inner = next;
      } else {
        outer = next;
        outer_tried = true;
      }
    } else if (upward ? next > best.at : next < best.at) {
      outer = next;
      outer_tried = true;
    } else {
      inner = next;
    }
  }
  return best;
}

}  // namespace planish
