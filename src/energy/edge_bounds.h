#pragma once

#include <algorithm>

#include "energy/flat_edge.h"

namespace planish {

/// How much longer or shorter an edge may get in the pattern, shares of its length on the patch,
/// above 0: infinite both where it may as it likes.
struct EdgeBounds {
  double longer = 0.0, shorter = 0.0;

  /// Of a strain that much shorter counts as much as `longer`: 1 where both bounds are equal.
  double ratio() const { return shorter / longer; }
};

/// What is left of a bound, and its multiplier.
struct Bound {
  double slack = 1.0, multiplier = 0.0;

  double stiffness() const { return multiplier / slack; }

  /// Of the multiplier, by a Newton step on slack * multiplier = mu.
  double multiplier_step(double mu, double slack_step) const {
    return (mu - multiplier * slack_step) / slack - multiplier;
  }
};

/// Derivatives of the barrier of an edge,
///
///     -mu log(t b - q) - mu log(t b' + q),
///
/// q its strain, b and b' its bounds, by its ends and by the scale t (docs/unfold.md, "Patterns
/// within limits"). Second ones are those of a primal-dual method: mu over the slack is the
/// multiplier there.
struct BarrierTerm {
  EdgeTerm ends;
  double scale, scale_twice;
  Vec2 mixed;

  BarrierTerm(const FlatEdge& edge, const LaidEdge& laid, const EdgeBounds& bounds,
              const Bound& longer, const Bound& shorter, double mu)
      : ends(laid.term(
            mu * (1.0 / longer.slack - 1.0 / shorter.slack) / edge.length,
            (longer.stiffness() + shorter.stiffness()) / (edge.length * edge.length),
            std::max(0.0, longer.multiplier - shorter.multiplier) / (edge.length * laid.length))) {
    const double b = bounds.longer, ratio = bounds.ratio();
    const double stiff_longer = longer.stiffness(), stiff_shorter = shorter.stiffness();
    scale = -mu * b * (1.0 / longer.slack + ratio * (1.0 / shorter.slack));
    scale_twice = b * b * (stiff_longer + ratio * ratio * stiff_shorter);
    mixed = (b * (ratio * stiff_shorter - stiff_longer) / edge.length) * laid.along;
  }
};

}  // namespace planish
