#include "flatten/verdict.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include <planish/measure/material.h>

#include "core/figure_text.h"
#include "flatten/limit_checks.h"
#include "flatten/outcome.h"
#include "flatten/steps/least_change.h"
#include "flatten/strain_limit_text.h"

namespace planish {

namespace {

// Of the largest strain: below the first it is rounding, up to the second nobody can measure it on
// cloth or leather.
constexpr double k_not_measurable = 1e-6;
constexpr double k_no_strain = 0.001;
// Of the rms: that of the usual end of auto, as its estimate has it.
constexpr double k_flat_strain = 1.1 * k_unmeasurable_strain;

constexpr double k_limit_rounding = 1e-9;

// A relative change below this is not worth a word.
constexpr double k_same_strain = 0.02;

/// The largest strain, stretch or compression, as the limit is for.
double largest_figure(const EdgeStrain& strain, Criterion what) {
  const std::string_view part = bounded_part(what);
  return part == "stretch"       ? strain.max_stretch
         : part == "compression" ? strain.max_compression
                                 : strain.max;
}

std::string capitalised(std::string text) {
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

/// With a material all limits of strain are its, but that of the rms.
bool is_of_material(const LimitCheck& check, const FlattenReport& report) {
  return !report.material.empty() && is_of_strain(check.what) &&
         check.what != Criterion::rms_strain;
}

/// Whether the strain is beyond the usual limits of the material on the last hundredth of the area.
bool is_beyond_somewhere(const EdgeStrain& strain, const Material& material) {
  const StrainLimits limits = limits_of(material);
  if (limits.p99 > 0.0) return strain.max > limits.p99;
  return strain.max_stretch > limits.p99_stretch || strain.max_compression > limits.p99_compression;
}

/// What could be cut to the pattern all the same.
std::string takers_text(const EdgeStrain& strain) {
  std::vector<std::string_view> names;
  bool is_beyond = false;  // somewhere on the last hundredth of the area
  for (const MaterialVerdict& verdict : materials_for(strain)) {
    if (!verdict.takes) continue;
    names.push_back(verdict.material->name);
    is_beyond = is_beyond || is_beyond_somewhere(strain, *verdict.material);
  }
  if (names.empty()) return "No material that is known here takes that.";
  std::string text(names.front());
  for (std::size_t k = 1; k < names.size(); ++k)
    text += (k + 1 < names.size() ? ", " : " and ") + std::string(names[k]);
  return capitalised(text) + (names.size() == 1 ? " takes that" : " take that") +
         (is_beyond ? " on 99 % of the area." : ".");
}

/// "(136, 302, 171)", in model units.
std::string point_text(Vec3 at) {
  return "(" + significant_text(at.x, 3) + ", " + significant_text(at.y, 3) + ", " +
         significant_text(at.z, 3) + ")";
}

/// "cotton (5.0 %)", by the limit that says most.
std::string named(const MaterialVerdict& verdict) {
  return verdict.material->name + " (" + percent_text(verdict.tightest.limit) +
         side_words(verdict.tightest.what) + ")";
}

/// Of the known materials the stiffest one that takes the strain, and the one before it, which does
/// not.
std::string neighbours_text(const EdgeStrain& strain) {
  std::string before;
  for (const MaterialVerdict& verdict : materials_for(strain)) {
    if (verdict.takes) return named(verdict) + " does" + before;
    before = ", " + named(verdict) + " does not";
  }
  return "no material that is known here does";
}

/// The stiffest material that takes the design as it is, where the form was changed for no
/// material.
std::string unchanged_sentence(const FlattenReport& report) {
  if (report.evolve.fairness.unchanged || report.rejected) return {};
  for (const MaterialVerdict& verdict : materials_for(report.design_pattern.strain)) {
    if (!verdict.takes) continue;
    const std::string& name = verdict.material->name;
    return " " + capitalised(name) + " takes the design as it is: --material " + name +
           " leaves the form unchanged.";
  }
  return {};
}

/// What a tolerance has, of which most is used up.
std::string end_of_tolerance(const FlattenReport& report, double distance) {
  constexpr double k_used_up = 0.8;
  const Fairness& fairness = report.evolve.fairness;
  const double moved = report.evolve.deviation.max / distance;
  const double fold = fairness.sharpest_fold ? fairness.sharpest_fold->degrees : 0.0;
  const double folded = fold / Tolerance::most_new_fold;
  const double bent = fairness.bending_added.value_or(0.0) / Tolerance::most_added;
  if (std::max({moved, folded, bent}) < k_used_up)
    return " No form with less stretch was found within --max-deviation.";
  if (moved >= std::max(folded, bent))
    return " Less would move some place further than --max-deviation allows.";
  const std::string form = folded >= bent ? "fold some place by more than " +
                                                significant_text(Tolerance::most_new_fold, 1) +
                                                " degrees beyond the design"
                                          : "bend the form more";
  return " Less would " + form +
         ", which --max-deviation does not allow: let the border move too (--border), or ask for a "
         "stretch in its place (--max-rms-strain).";
}

/// What would take more of the strain out, where it was left for the sake of the form.
std::string way_on(const FlattenReport& report) {
  const Auto* options = report.evolve.auto_options();
  if (options == nullptr || options->prefer != Prefer::smooth ||
      is_too_small_to_measure(report.unfold.strain))
    return {};
  const StopReason stop = report.evolve.result.stop;
  const bool is_end = stop == StopReason::deviation_limit || stop == StopReason::smooth_limit;
  if (is_end && options->max_bending == 0.0 && !std::isinf(options->max_deviation))
    return end_of_tolerance(report, options->max_deviation);
  if (stop == StopReason::deviation_limit)
    return " Less would move some place further than --max-deviation allows.";
  if (stop == StopReason::smooth_limit && options->max_bending > 0.0)
    return " Less would bend the form more than --max-bending allows.";
  if (stop == StopReason::smooth_limit)
    return " Less would crumple the form: let the border move (--border), cut the patch "
           "(suggest-cuts), or take folds (--prefer flat).";
  if (stop != StopReason::strain_met) return {};
  return " --prefer flat takes the rest out.";
}

bool keeps_lengths(const FlattenReport& report) {
  return report.evolve.after.flattenable && report.unfold.strain.max <= k_no_strain;
}

/// What keeps the mesh from showing whether it lies flat, as it came out; null where nothing does.
const Caution* unjudged_caution(const FlattenReport& report) {
  const bool is_flat = keeps_lengths(report) || is_too_small_to_measure(report.unfold.strain);
  return unjudged_by(report.cautions, is_flat);
}

bool is_changed(const FlattenReport& report) {
  return !report.evolve.fairness.unchanged && !report.evolve.result.history.empty();
}

std::string moved_sentence(const FlattenReport& report) {
  if (report.rejected) {
    return " Changing the form would have stretched the pattern more, to " +
           percent_text(report.rejected->rms) + " as a rule, so this is the design as it is.";
  }
  if (!is_changed(report)) return " The form was not changed.";
  if (flatness_of(report) == Flatness::limit_kept) return {};  // the first words say it
  return " No place moved further than " +
         length_text(report.evolve.deviation.max, report.unfold.unit) + ".";
}

/// The first words: whether it lies flat, or may be cut at all.
std::string state_words(const FlattenReport& report) {
  if (report.unfold.pattern.overlaps) return "Do not cut this pattern: it overlaps itself";
  if (report.unfold.pattern.flipped_triangles > 0)
    return "Do not cut this pattern: parts of it are flipped over";
  switch (flatness_of(report)) {
    case Flatness::flat:
      return "Lies flat without stretch";
    case Flatness::not_known:
      return "Cannot be judged: " + std::string(words_of(*unjudged_caution(report)));
    case Flatness::unmeasurable:
      return "Flat but for a stretch too small to measure";
    case Flatness::stretched:
      if (report.outcome().misses(Criterion::stretched)) return "Does not lie flat without stretch";
      return sheet_needed_text(report.unfold.strain);
    case Flatness::limit_kept:
    case Flatness::limit_missed:
      break;
  }
  const std::vector<LimitCheck>& limits = report.unfold.limits;
  const auto missed = std::find_if(limits.begin(), limits.end(),
                                   [](const LimitCheck& check) { return !check.met; });
  if (missed != limits.end()) return "Not within " + strain_limit_name(*missed, report);
  const auto of_material =
      std::count_if(limits.begin(), limits.end(),
                    [&](const LimitCheck& check) { return is_of_material(check, report); });
  return "Within " +
         (of_material > 1 ? "what " + report.material + " takes"
                          : strain_limit_name(limits.front(), report)) +
         (is_changed(report) ? ", with the form changed by up to " +
                                   length_text(report.evolve.deviation.max, report.unfold.unit)
                             : "");
}

/// Where the form is not as it should be: that, to follow the first words.
std::string form_clause(const FlattenReport& report) {
  const std::string faults = form_faults(report.evolve);
  if (faults.empty()) return {};
  const Flatness flatness = flatness_of(report);
  const bool is_bad = flatness == Flatness::limit_missed || flatness == Flatness::stretched ||
                      report.unfold.pattern.overlaps || report.unfold.pattern.flipped_triangles > 0;
  const bool is_list =
      flatness == Flatness::stretched && !report.outcome().misses(Criterion::stretched);
  const std::string link = is_list                              ? ";"
                           : is_bad                             ? ", and"
                           : flatness == Flatness::unmeasurable ? ", yet"
                                                                : ", but";
  return link + " the form " + faults;
}

/// Whether the pattern was evened out for limits, and that of the design beside it was not.
bool is_evened_out_alone(const FlattenReport& report) {
  return !report.unfold.limits.empty() && report.unfold.unlimited_strain &&
         !report.design_pattern.unlimited_strain;
}

std::string stretch_sentence(const FlattenReport& report) {
  const EdgeStrain &before = report.design_pattern.strain, &after = report.unfold.strain;
  if (keeps_lengths(report)) {
    // Of the mesh alone where that is not the surface.
    const std::string kept = std::string(" The pattern keeps every length") +
                             (report.cautions.empty() ? "" : " of the mesh");
    return kept +
           (after.max < k_not_measurable ? "." : " to within " + percent_text(after.max) + ".");
  }
  std::string text = " The usual stretch is " + percent_text(after.rms) + ", the largest " +
                     largest_strain_text(after);
  if (!report.evolve.method && after.max > k_not_measurable) {
    text += ", near " + point_text(0.5 * (report.processed.positions()[after.worst_edge[0]] +
                                          report.processed.positions()[after.worst_edge[1]]));
  }
  if (std::abs(after.rms - before.rms) > std::max(k_same_strain * before.rms, k_not_measurable))
    text += std::string("; for the design as it is") +
            (is_evened_out_alone(report) ? ", with least stretch, " : " ") +
            percent_text(before.rms) + " and " + largest_strain_text(before);
  return text + ".";
}

/// What can be done with a pattern that is stretched and has no limit to keep.
std::string use_sentences(const FlattenReport& report) {
  if (report.unfold.pattern.overlaps) {
    const bool may_change = report.evolve.fairness.unchanged && !keeps_lengths(report);
    return may_change
               ? " Let the form change more (--pick 5 takes nearly all stretch out), or divide "
                 "the patch (--cut)."
               : " Divide the patch (--cut).";
  }
  const Flatness flatness = flatness_of(report);
  if (flatness == Flatness::limit_missed)
    return " To keep it, cut the patch (suggest-cuts finds where), or take a material that "
           "stretches more.";
  if (flatness == Flatness::limit_kept && !form_faults(report.evolve).empty())
    return " To keep the form, cut the patch (suggest-cuts finds where), or take a material that "
           "stretches more.";
  if (report.unfold.pattern.flipped_triangles > 0 || flatness == Flatness::flat ||
      flatness == Flatness::not_known || flatness == Flatness::limit_kept)
    return {};
  const bool is_said =  // by the first words
      flatness == Flatness::stretched && !report.outcome().misses(Criterion::stretched);
  return (is_said ? "" : " " + takers_text(report.unfold.strain)) + unchanged_sentence(report) +
         way_on(report);
}

/// Whether a designer would take the form; empty where it is that of the design.
std::string form_sentence(const FlattenReport& report) {
  const Fairness& fairness = report.evolve.fairness;
  if (fairness.unchanged) return {};
  const std::string loss = form_loss_text(fairness);
  const std::string lost = loss.empty() ? "" : " The form is not kept: " + loss + ".";
  if (fairness.is_smooth()) return " The form stayed smooth." + lost;
  if (!fairness.bending_ratio) return " The form was a plane, and is bent now.";
  const std::string_view word = smoothness_word(fairness);
  const std::string start = " The form is " + std::string(word) + ": ";
  if (!fairness.form_change) {
    return start + "it is bent " + significant_text(*fairness.bending_ratio, 2) +
           " times as much as it was." + lost;
  }
  const FormChange& seen = *fairness.form_change;
  const double more = seen.is_rippled() ? seen.ripple : seen.fold;
  return start + (seen.is_rippled() ? "in places" : "in one place") + " it is bent " +
         significant_text(std::sqrt(1.0 + more * more), 2) + " times as sharply as it was." + lost;
}

}  // namespace

std::string sheet_needed_text(const EdgeStrain& strain) {
  return "Needs a sheet that takes " + percent_text(strain.p99) + ": " + neighbours_text(strain);
}

std::string largest_strain_text(const EdgeStrain& strain) {
  return percent_text(strain.max) +
         (strain.max_compression > strain.max_stretch ? " (compression)" : "");
}

std::string not_judged_text(const FlattenReport& report) {
  if (flatness_of(report) != Flatness::not_known) return {};
  return std::string(words_of(*unjudged_caution(report)));
}

std::string form_faults(const EvolveReport& evolve) {
  return joined(find_form_faults(evolve));
}

Flatness flatness_of(const FlattenReport& report) {
  if (keeps_lengths(report))
    return unjudged_caution(report) == nullptr ? Flatness::flat : Flatness::not_known;
  const std::vector<LimitCheck>& limits = report.unfold.limits;
  if (!limits.empty()) {
    return all_kept(limits) ? Flatness::limit_kept : Flatness::limit_missed;
  }
  if (unjudged_caution(report) != nullptr) return Flatness::not_known;
  return is_too_small_to_measure(report.unfold.strain) ? Flatness::unmeasurable
                                                       : Flatness::stretched;
}

bool is_too_small_to_measure(const EdgeStrain& strain) {
  return strain.rms <= k_flat_strain;
}

std::string strain_limit_name(const LimitCheck& check, const FlattenReport& report) {
  const std::string limit = percent_text(check.limit) + side_words(check.what);
  const bool of_area = is_of_area(check.what);
  if (is_of_material(check, report)) {
    const bool is_beyond = of_area && largest_figure(report.unfold.strain, check.what) >
                                          check.limit * (1.0 + k_limit_rounding);
    return "the " + limit + " that " + report.material + " takes" +
           (is_beyond ? " on 99 % of the area"
            : of_area ? ""
                      : " at any edge");
  }
  return "the limit of " + limit + scope_words(check.what);
}

std::string form_loss_text(const Fairness& fairness) {
  const FormChange seen = fairness.form_change.value_or(FormChange{});
  std::string text;
  const auto add = [&text](const std::string& words) {
    text += (text.empty() ? "" : ", ") + words;
  };
  if (fairness.height_ratio.value_or(1.0) < k_kept_height)
    add("height " + percent_text(*fairness.height_ratio) + " of the design's");
  if (seen.has_lost_relief())
    add("hills and hollows lost " + percent_text(std::min(1.0, seen.relief_lost)) +
        " of their height");
  if (seen.has_lost_edge()) add("edges are rounded off");
  if (seen.is_dented()) add("a dent or bulge is new");
  if (seen.is_uneven()) add("small features changed");
  if (fairness.largest_move.value_or(0.0) > k_kept_move)
    add("a part moved by " + percent_text(*fairness.largest_move) + " of the whole size");
  return text;
}

std::string cautions_text(std::span<const Caution> cautions, Unit unit) {
  std::string text;
  for (const Caution& caution : cautions)
    text += (text.empty() ? "" : " ") + caution_text(caution, unit);
  return text;
}

std::string verdict_text(const FlattenReport& report) {
  const std::string cautions = cautions_text(report.cautions, report.unfold.unit);
  std::string text = state_words(report) + form_clause(report) + "." + stretch_sentence(report) +
                     use_sentences(report) + (cautions.empty() ? "" : " " + cautions) +
                     moved_sentence(report) + form_sentence(report);
  if (!report.unfold.pattern.converged) {
    text += " Unfolding stopped before it was done: the stretch may be more than it need be.";
  }
  const std::string question = unit_question(report.unfold);
  return question.empty() ? text : text + " " + question;
}

std::string border_text(const FlattenReport& report) {
  const auto& obstruction = report.evolve.before.obstruction;
  if (!obstruction || !obstruction->is_notable()) return {};
  const Flatness flatness = flatness_of(report);
  const bool is_flat = flatness == Flatness::flat || flatness == Flatness::not_known ||
                       flatness == Flatness::unmeasurable;
  if (is_flat && form_faults(report.evolve).empty()) return {};  // it has gone, without harm
  return std::string(obstruction->has_flat_border()
                         ? "The edge lies in a plane and only a plane piece fits it: "
                         : "The edge is too short for so much surface: ") +
         "at least " + percent_text(obstruction->excess_share) +
         " of the area of the design must go for a piece with this edge to lie flat, so put in a "
         "dart or a cut to keep the form.";
}

}  // namespace planish
