#include "flatten/outcome.h"

#include <algorithm>
#include <limits>
#include <span>
#include <string_view>
#include <variant>

#include <planish/flatten/product.h>

#include "flatten/limit_checks.h"
#include "flatten/verdict.h"

namespace planish {

namespace {

/// How much of a limit is used up: above 1 beyond it.
double share_used(const LimitCheck& check) {
  const double part = check.what == Criterion::angle ? check.limit : check.value;
  const double whole = check.what == Criterion::angle ? check.value : check.limit;
  if (whole > 0.0) return part / whole;
  return part > 0.0 ? std::numeric_limits<double>::infinity() : 0.0;
}

/// What is met comes first, then what is further from its limit.
bool is_better(const LimitCheck& a, const LimitCheck& b) {
  return a.met != b.met ? a.met : share_used(a) < share_used(b);
}

/// Collects what is missed.
class Judgement {
 public:
  explicit Judgement(StopReason reason) { outcome_.reason = reason; }

  Judgement& limits(std::span<const LimitCheck> checks) {
    for (const LimitCheck& check : checks)
      miss_if(!check.met, check.what);
    const auto worst = std::max_element(checks.begin(), checks.end(), is_better);
    if (worst != checks.end()) outcome_.worst = *worst;
    return *this;
  }
  Judgement& form(std::span<const FormFault> faults) {
    for (const FormFault& fault : faults)
      miss_if(true, fault.what);
    return *this;
  }
  Judgement& pattern(const UnfoldReport& unfold) {
    miss_if(is_absurdly_small(unfold), Criterion::size);
    miss_if(unfold.pattern.overlaps, Criterion::overlap);
    miss_if(unfold.pattern.flipped_triangles > 0, Criterion::flipped_triangles);
    return *this;
  }
  Judgement& miss_if(bool is_missed, Criterion what) {
    if (is_missed) outcome_.missed.push_back(what);
    return *this;
  }

  Outcome outcome() {
    std::vector<Criterion>& missed = outcome_.missed;
    std::sort(missed.begin(), missed.end());
    missed.erase(std::unique(missed.begin(), missed.end()), missed.end());
    return std::move(outcome_);
  }

 private:
  Outcome outcome_;
};

/// Without a limit of strain or a tolerance, a changed surface is to lie flat.
bool is_stretched(const EdgeStrain& strain, double largest_move, bool is_rejected,
                  std::span<const LimitCheck> limits) {
  const bool has_limit = is_rejected || std::any_of(limits.begin(), limits.end(), [](auto& check) {
                           return is_of_strain(check.what) || check.what == Criterion::deviation;
                         });
  return !has_limit && largest_move > 0.0 && !is_too_small_to_measure(strain);
}

/// Of a patch that was flattened.
Outcome outcome_of(const UnfoldReport& unfold, double largest_move, StopReason stop,
                   bool is_rejected, std::span<const LimitCheck> limits,
                   std::span<const FormFault> faults) {
  return Judgement(stop)
      .limits(limits)
      .miss_if(is_rejected, Criterion::rejected)
      .miss_if(is_stretched(unfold.strain, largest_move, is_rejected, limits), Criterion::stretched)
      .form(faults)
      .pattern(unfold)
      .outcome();
}

/// Whether a fold in one place is all that is not smooth.
bool is_only_folded(const Fairness& fairness) {
  return fairness.form_change && fairness.bending_ratio && !fairness.is_smooth() &&
         !fairness.form_change->is_rippled();
}

/// What became of a form that is not kept.
std::string loss_of(const Fairness& fairness) {
  const FormChange seen = fairness.form_change.value_or(FormChange{});
  const bool is_lost = seen.has_lost_relief() ||
                       fairness.height_ratio.value_or(1.0) < k_kept_height ||
                       fairness.largest_move.value_or(0.0) > k_kept_move;
  if (is_lost) return "is lost";
  if (seen.is_dented()) return "is dented";
  return seen.has_lost_edge() ? "lost its edges" : "is uneven";
}

/// Whether a run that was to end by the strain ended so, or with nothing left to do.
bool ended_by_strain(StopReason reason) {
  return reason == StopReason::strain_met || reason == StopReason::converged ||
         reason == StopReason::reached_target;
}

}  // namespace

std::string_view smoothness_word(const Fairness& fairness) {
  constexpr double crumpled = 3.0;  // ripple
  if (fairness.is_smooth()) return "smooth";
  if (is_only_folded(fairness)) return "folded";
  return fairness.form_change && fairness.form_change->ripple <= crumpled ? "rippled" : "crumpled";
}

std::vector<FormFault> find_form_faults(const EvolveReport& evolve) {
  const Fairness& fairness = evolve.fairness;
  const bool is_folded = is_only_folded(fairness);
  std::vector<FormFault> faults;
  if (!fairness.is_smooth() && !is_folded)
    faults.push_back({Criterion::crumpled, "is " + std::string(smoothness_word(fairness))});
  if (!fairness.keeps_form()) faults.push_back({Criterion::form, loss_of(fairness)});
  if (is_folded) faults.push_back({Criterion::fold, "has a new fold"});
  if (evolve.after.self_intersections.pairs > evolve.before.self_intersections.pairs)
    faults.push_back({Criterion::self_intersections, "goes through itself"});
  return faults;
}

std::string joined(const std::vector<FormFault>& faults) {
  constexpr std::string_view verb = "is ";
  std::string text;
  for (const FormFault& fault : faults) {
    const bool is_said = text.starts_with(verb) && fault.text.starts_with(verb);
    text += (text.empty() ? "" : " and ") + fault.text.substr(is_said ? verb.size() : 0);
  }
  return text;
}

bool Outcome::limits_met() const {
  return std::none_of(missed.begin(), missed.end(),
                      [](Criterion what) { return what <= Criterion::failure; });
}

bool Outcome::misses(Criterion what) const {
  return std::find(missed.begin(), missed.end(), what) != missed.end();
}

std::string_view EvolveReport::method_name() const {
  return method ? name_of(*method) : "none";
}

const Auto* EvolveReport::auto_options() const {
  return method ? std::get_if<Auto>(&*method) : nullptr;
}

Outcome EvolveReport::outcome() const {
  Judgement judgement(result.stop);
  judgement.limits(limit_checks(*this)).form(find_form_faults(*this));
  if (const Auto* options = auto_options(); options && !ended_by_strain(result.stop)) {
    for (const LimitCheck& check : check_limits(EdgeStrain{}, options->limits))
      judgement.miss_if(true, check.what);
  }
  return judgement.outcome();
}

Outcome UnfoldReport::outcome() const {
  return outcome_of(*this, 0.0, StopReason::design_kept, false, limits, {});
}

Outcome FlattenReport::outcome() const {
  return outcome_of(unfold, evolve.deviation.max, evolve.result.stop, rejected.has_value(),
                    limit_checks(*this), find_form_faults(evolve));
}

Outcome FinishedPatch::outcome() const {
  return outcome_of(unfold, deviation.max, stop, rejected.has_value(), limits, form_faults);
}

Outcome PatchResult::outcome() const {
  return finished ? finished->outcome() : Outcome{.missed = {Criterion::failure}};
}

}  // namespace planish
