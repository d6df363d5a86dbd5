// Included by one source file for each set of instructions.
#pragma once

#include "core/lanes/lanes.h"

namespace planish::PLANISH_ISA {

/// In each lane, the way down to a minimum of f on [low, high] from 0: two Gauss-Newton steps, then
/// secant steps of the slope, which end sooner where the residuals stay large. All are kept inside
/// a bracket that shrinks at every evaluation: a step that would leave it, or that did not lower f,
/// is replaced by its middle. Converges from any start.
class LineSearch {
 public:
  static constexpr int k_most_evaluations = 16;
  static constexpr int k_gauss_newton_steps = 2;
  static constexpr double k_tolerance = 1e-3;  // b is flat at its minimum

  /// @pre low <= 0 <= high
  /// @param idle lanes that need not be searched
  LineSearch(const Real& value, const Real& slope, const Real& curvature, const Real& low,
             const Real& high, Mask idle)
      : value_(value),
        slope_(slope),
        curvature_(curvature),
        upward_(slope < 0.0),
        outer_(select(upward_, high, low)),
        enough_(k_tolerance * least(all(1.0), high - low)),
        done_(idle | (slope == 0.0) | (outer_ == 0.0)) {}

  /// Where f should be evaluated next; that of finished lanes does not matter.
  Real next() {
    const Real rise = ++evaluations_ > k_gauss_newton_steps
                          ? (slope_ - other_slope_) / (at_ - other_)
                          : curvature_;
    const Real bend = select(rise > 0.0, rise, curvature_);
    Real place = select(bend > 0.0, at_ - slope_ / bend, outer_);
    const Mask inside = (place > least(inner_, outer_)) & (place < greatest(inner_, outer_));
    const Mask beyond = (upward_ & (place >= outer_)) | (~upward_ & (place <= outer_));
    const Real middle = select(beyond & ~outer_tried_, outer_, 0.5 * (inner_ + outer_));
    place = select(inside, place, middle);
    done_ |= absolute(place - at_) < enough_;
    return select(done_, at_, place);
  }

  bool done() const { return !any(~done_); }

  /// Tells what f is there; returns the lanes where it is the lowest so far.
  Mask tell(const Real& place, const Real& value, const Real& slope, const Real& curvature) {
    const Mask better = ~done_ & (value < value_);
    const Mask worse = ~done_ & ~(value < value_);
    const Mask still_falls = (upward_ & (slope < 0.0)) | (~upward_ & (slope > 0.0));
    const Mask further = (upward_ & (place > at_)) | (~upward_ & (place < at_));
    const Mask to_outer = (better & ~still_falls) | (worse & further);
    inner_ = select((better & still_falls) | (worse & ~further), place, inner_);
    outer_ = select(to_outer, place, outer_);
    outer_tried_ |= to_outer;
    other_ = select(better, at_, select(worse, place, other_));
    other_slope_ = select(better, slope_, select(worse, slope, other_slope_));
    at_ = select(better, place, at_);
    value_ = select(better, value, value_);
    slope_ = select(better, slope, slope_);
    curvature_ = select(better, curvature, curvature_);
    return better;
  }

  /// The lowest place seen, 0 where f rises both ways, and f there.
  Real at() const { return at_; }
  Real value() const { return value_; }

 private:
  Real at_{}, value_, slope_, curvature_;
  Mask upward_;
  // The minimum lies between inner (tried) and outer (tried only where outer_tried).
  Real inner_{}, outer_;
  Real other_{}, other_slope_{};  // the place evaluated before or after the lowest
  Real enough_;
  int evaluations_ = 0;
  Mask outer_tried_{}, done_;
};

}  // namespace planish::PLANISH_ISA
