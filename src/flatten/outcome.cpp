#include <algorithm>
#include <limits>
#include <span>
#include <variant>

#include "flatten/limit_checks.h"

namespace planish {

namespace {

/// How much of a limit is used up: above 1 beyond it.
double share_used(const LimitCheck& check) {
  const double part = check.what == LimitOf::angle ? check.limit : check.value;
  const double whole = check.what == LimitOf::angle ? check.value : check.limit;
  if (whole > 0.0) return part / whole;
  return part > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

/// What is met comes first, then what is further from its limit.
bool is_better(const LimitCheck& a, const LimitCheck& b) {
  return a.met != b.met ? a.met : share_used(a) < share_used(b);
}

Outcome outcome_of(std::span<const LimitCheck> checks, StopReason reason) {
  Outcome outcome{true, reason};
  for (const LimitCheck& check : checks)
    outcome.met = outcome.met && check.met;
  const auto worst = std::max_element(checks.begin(), checks.end(), is_better);
  if (worst != checks.end()) outcome.worst = *worst;
  return outcome;
}

/// Whether a run that was to end by the strain ended so, or with nothing left to do.
bool ended_by_strain(const Method& method, const Outcome& outcome) {
  const auto* options = std::get_if<Auto>(&method);
  if (options == nullptr || (options->max_strain == 0.0 && options->max_rms_strain == 0.0))
    return true;
  return outcome.reason == StopReason::strain_met || outcome.reason == StopReason::converged ||
         outcome.target_met();
}

}  // namespace

Outcome EvolveReport::outcome() const {
  Outcome outcome = outcome_of(limit_checks(*this), result.stop);
  outcome.met = outcome.met && ended_by_strain(method, outcome);
  return outcome;
}

Outcome FlattenReport::outcome() const {
  Outcome outcome = outcome_of(limit_checks(*this), evolve.result.stop);
  outcome.met = outcome.met && !rejected;
  return outcome;
}

}  // namespace planish
