#pragma once

#include <algorithm>
#include <optional>

namespace planish {

/// A step that backtracking accepted.
struct AcceptedStep {
  double size = 1.0;  ///< fraction of the step that was taken
  int halvings = 0;
};

/// Backtracking (Armijo 1966): tries a step size, then each time half of the last.
/// @param accept of a step size and the number of halvings: whether that step is taken
/// @return none where all trials failed
template <class Accept>
std::optional<AcceptedStep> backtrack(double first, int most_trials, const Accept& accept) {
  AcceptedStep step{first, 0};
  for (; step.halvings < most_trials; ++step.halvings, step.size *= 0.5) {
    if (accept(step.size, step.halvings)) return step;
  }
  return std::nullopt;
}

/// How damping follows steps (Levenberg 1944, Marquardt 1963): less after a whole one, more after
/// one that was halved twice or failed.
struct DampingRule {
  double ease, tighten;  ///< its factors
  double first = 0.0;    ///< what it comes to at least where it is tightened
  double least = 0.0;    ///< what it falls to at least
  double most = 1e300;   ///< what it grows to at most
  double nothing = 0.0;  ///< below this it falls to 0

  double after(const std::optional<AcceptedStep>& step, double damping) const {
    if (!step || step->halvings >= 2) return std::min(most, std::max(first, tighten * damping));
    if (step->halvings > 0) return damping;
    return damping < nothing ? 0.0 : std::max(least, ease * damping);
  }
};

}  // namespace planish
