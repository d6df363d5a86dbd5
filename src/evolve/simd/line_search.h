// Included by one source file for each set of instructions.
#pragma once

#include "core/simd/simd.h"

namespace planish::PLANISH_ISA {

/// A sum of squares on a line near its start, from the first three Taylor coefficients of each term
/// that is squared: exact to the third power of the step.
struct LineModel {
  Real c[6];    ///< by powers of the place; the last is for LineSearch
  Real spread;  ///< Gauss-Newton's half of the second derivative, which is not negative

  /// Adds the square of r + a1 t + a2 t^2 + a3 t^3, but for the fifth power and up.
  void add_square(const Real& r, const Real& a1, const Real& a2, const Real& a3) {
    const Real twice = r + r, square = a1 * a1, twice_a1 = a1 + a1;
    c[0] += r * r;
    c[1] += twice * a1;
    c[2] += square + twice * a2;
    c[3] += twice * a3 + twice_a1 * a2;
    c[4] += a2 * a2 + twice_a1 * a3;
    spread += square;
  }

  Real at(const Real& t) const {
    return c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5]))));
  }
  Real slope(const Real& t) const {
    return c[1] + t * (2.0 * c[2] + t * (3.0 * c[3] + t * (4.0 * c[4] + t * (5.0 * c[5]))));
  }
  Real curvature(const Real& t) const {
    return 2.0 * c[2] + t * (6.0 * c[3] + t * (12.0 * c[4] + t * (20.0 * c[5])));
  }
};

/// In each lane, the way down to a minimum of f on [low, high] from 0. The minimum of a model of f
/// is evaluated; what f is there gives the model its next order, and so on until the model's
/// minimum stays and it foretold the last value. All positions are inside a bracket that shrinks at
/// every evaluation: a step that would leave it is replaced by its end or the middle. f never
/// rises.
class LineSearch {
 public:
  static constexpr int k_most_evaluations = 16;  // the one at 0 included
  static constexpr double k_tolerance = 1e-3;    // of the interval; b is flat at its minimum
  static constexpr double k_trust = 5e-3;        // of the fall: an error that the model may make
  static constexpr double k_probe = 0.1;         // of the bracket: how far to look if it does

  /// @pre low <= 0 <= high
  /// @param idle lanes that need not be searched
  LineSearch(const LineModel& model, const Real& low, const Real& high, Mask idle)
      : model_(model),
        corrected_(model),
        value_(model.c[0]),
        upward_(model.c[1] < 0.0),
        outer_(select(upward_, high, low)),
        enough_(k_tolerance * min(broadcast(1.0), high - low)),
        done_(idle | ~((model.c[1] < 0.0) | (model.c[1] > 0.0)) | (outer_ == 0.0)) {
    // Gauss-Newton's step, which leads down, and one of Newton's from there; next() adds another.
    const Real place = -0.5 * model.c[1] / model.spread;
    from_ = bettered(select(within(place), place, outer_));
  }

  /// Where f should be evaluated next; that of finished lanes does not matter.
  Real next() {
    Real place = bettered(from_);
    // A tried end is no place to go.
    const Mask at_outer = place == outer_, at_inner = place == inner_;
    place = select((at_outer & outer_tried_) | at_inner, 0.5 * (at_ + place), place);
    // What the model says is believed where it foretold the last value, and so near the start that
    // there is nothing to look at.
    const Mask stays = absolute(place - at_) < enough_;
    done_ |= stays & (foretold_ | (at_ == 0.0));
    place = select(stays, at_ - k_probe * (at_ - inner_), place);
    return select(done_, at_, place);
  }

  bool done() const { return !any(~done_); }

  /// Tells what f is there; returns the lanes where it is the lowest so far.
  Mask tell(const Real& place, const Real& value) {
    const Real miss = absolute(value - corrected_.at(place));
    foretold_ = miss <= k_trust * (model_.c[0] - value);
    const Mask better = ~done_ & (value < value_), worse = ~done_ & ~(value < value_);
    const Mask further = (upward_ & (place > at_)) | (~upward_ & (place < at_));
    inner_ = select(better & further, at_, select(worse & ~further, place, inner_));
    const Mask to_outer = (better & ~further) | (worse & further);
    outer_ = select(to_outer, select(better, at_, place), outer_);
    outer_tried_ |= to_outer | (better & (place == outer_));
    at_ = select(better, place, at_);
    value_ = select(better, value, value_);
    correct(place, value);
    from_ = at_;
    return better;
  }

  /// The lowest place seen, 0 where f rises both ways, and f there.
  Real at() const { return at_; }
  Real value() const { return value_; }

 private:
  Mask within(const Real& place) const {
    return (place > min(inner_, outer_)) & (place < max(inner_, outer_));
  }

  /// Newton's step to the minimum of the model, within the bracket. Where the model bends down:
  /// from the lowest place seen to the end of the bracket that is downhill; else no step.
  Real bettered(const Real& place) const {
    const Real low = min(inner_, outer_), high = max(inner_, outer_);
    const Real slope = corrected_.slope(place), bend = corrected_.curvature(place);
    const Real stepped = min(max(place - slope / bend, low), high);
    const Real downhill = select(place == at_, select(slope < 0.0, high, low), place);
    return select(bend > 0.0, stepped, downhill);
  }

  /// Makes the model go through the last two positions: with E what it lacks there, E / t^4 is
  /// taken as linear.
  void correct(const Real& place, const Real& value) {
    const Real square = place * place;
    const Real lack = (value - model_.at(place)) / (square * square);
    const Real run = place - last_place_;
    const Real rise =
        select((last_place_ != 0.0) & (run != 0.0), (lack - last_lack_) / run, Real{});
    corrected_.c[4] = model_.c[4] + lack - rise * place;
    corrected_.c[5] = rise;
    last_place_ = place, last_lack_ = lack;
  }

  LineModel model_, corrected_;
  Real at_{}, value_, from_{};
  Mask upward_;
  // The minimum lies between inner (tried) and outer (tried only where outer_tried).
  Real inner_{}, outer_;
  Real last_place_{}, last_lack_{};
  Real enough_;
  Mask outer_tried_{}, foretold_{}, done_;
};

}  // namespace planish::PLANISH_ISA
