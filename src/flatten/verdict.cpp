#include "flatten/verdict.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>
#include <variant>
#include <vector>

#include <planish/measure/material.h>

#include "core/figure_text.h"
#include "flatten/limit_checks.h"

namespace planish {

namespace {

// Of the largest strain: below the first it is rounding, up to the second nobody can measure it on
// cloth or leather.
constexpr double k_not_measurable = 1e-6;
constexpr double k_no_strain = 0.001;
// Of the rms: that of the usual end of auto, as its estimate has it.
constexpr double k_flat_strain = 1.1 * k_unmeasurable_strain;

// Relative changes below these are not worth a word.
constexpr double k_same_energy = 0.005, k_same_strain = 0.02;

std::string strain_text(const EdgeStrain& strain) {
  return percent_text(strain.rms) + " rms (" + percent_text(strain.max) + " at worst)";
}

/// What a limit of strain that was given says of the pattern; empty where there is none.
std::string limit_words(const FlattenReport& report) {
  std::string words;
  for (const LimitCheck& check : limit_checks(report)) {
    const bool is_of_area = check.what == LimitOf::p99_strain;
    const bool is_of_rms = check.what == LimitOf::rms_strain;
    if (check.what != LimitOf::strain && !is_of_area && !is_of_rms) continue;
    const std::string limit = percent_text(check.limit) + (is_of_rms    ? " (rms)"
                                                           : is_of_area ? " on 99 % of the area"
                                                                        : "");
    if (!check.met) return "Not within the limit of " + limit;
    if (words.empty()) words = "Not without stretch, but within the limit of " + limit;
  }
  return words;
}

/// Who could be cut to the pattern all the same.
std::string takers_text(const EdgeStrain& strain) {
  std::vector<std::string_view> names;
  for (const Material& material : materials()) {
    if (strain.p99 <= material.max_strain) names.push_back(material.name);
  }
  if (names.empty()) return "No material that is known here takes that.";
  std::string text(names.front());
  for (std::size_t k = 1; k < names.size(); ++k)
    text += (k + 1 < names.size() ? ", " : " and ") + std::string(names[k]);
  text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text + (names.size() == 1 ? " takes that." : " take that.");
}

/// What would take the rest of the strain out, where it was left for the sake of the form.
std::string way_on(const FlattenReport& report) {
  const auto* options = std::get_if<Auto>(&report.evolve.method);
  if (options == nullptr || options->prefer != Prefer::smooth) return {};
  if (report.evolve.result.stop == StopReason::smooth_limit)
    return " Less would crumple the form: let the border move (--border), cut the patch "
           "(suggest-cuts), or take folds (--prefer flat).";
  if (report.evolve.result.stop != StopReason::strain_met) return {};
  return " --prefer flat takes the rest out.";
}

std::string state_sentence(const FlattenReport& report) {
  const Pattern& pattern = report.unfold.pattern;
  const EdgeStrain& strain = report.unfold.strain;
  if (pattern.overlaps) {
    return "Not to be cut from one piece: the pattern overlaps itself, so divide the patch. It is "
           "strained by " +
           strain_text(strain) + ".";
  }
  if (pattern.flipped_triangles > 0) {
    return "Not to be cut: " + count_text(pattern.flipped_triangles) +
           (pattern.flipped_triangles == 1 ? " triangle" : " triangles") +
           " of the pattern lie face down. It is strained by " + strain_text(strain) + ".";
  }
  if (report.evolve.after.flattenable) {
    if (strain.max < k_not_measurable) return "Flattenable: the pattern keeps every length.";
    if (strain.max <= k_no_strain) {
      return "Flattenable: the pattern keeps every length to within " + percent_text(strain.max) +
             ".";
    }
    return "Flattenable by its angles, yet the pattern is strained by " + strain_text(strain) + ".";
  }
  const std::string limits = limit_words(report);
  if (!limits.empty()) return limits + ": the pattern is strained by " + strain_text(strain) + ".";
  const bool is_flat = strain.rms <= k_flat_strain;
  return std::string(is_flat ? "Flat but for a stretch that nobody can measure"
                             : "Not flat without stretch") +
         ": the pattern is strained by " + strain_text(strain) + ". " + takers_text(strain) +
         way_on(report);
}

std::string energy_phrase(double before, double after) {
  const double ratio = before > 0.0 ? after / before : after > 0.0 ? 10.0 : 1.0;
  if (std::abs(ratio - 1.0) <= k_same_energy) return "left the energy where it was";
  if (after == 0.0) return "brought the energy to 0";
  if (ratio < 0.01) {
    return "brought the energy down to 1/" + about_text(1.0 / ratio) + " of what it was";
  }
  if (ratio < 1.0) return "lowered the energy by " + percent_text(1.0 - ratio);
  if (before == 0.0) return "raised the energy from 0";
  if (ratio < 2.0) return "raised the energy by " + percent_text(ratio - 1.0);
  return "raised the energy to " + about_text(ratio) + " times what it was";
}

std::string strain_phrase(double before, double after) {
  if (std::abs(after - before) <= std::max(k_same_strain * before, k_not_measurable)) {
    return "left the strain where it was";
  }
  return (after < before ? "lowered the strain from " : "raised the strain from ") +
         percent_text(before) + " to " + percent_text(after) + " rms";
}

std::string effort_sentence(const FlattenReport& report) {
  const EvolveReport& evolve = report.evolve;
  const auto& history = evolve.result.history;
  if (history.empty()) {
    return evolve.before.flattenable ? "It came so, and no vertex was moved."
                                     : "No sweep was made, and no vertex was moved.";
  }
  const std::string sweeps = count_text(history.size()) + " " +
                             std::string(name_of(evolve.method)) +
                             (history.size() == 1 ? " sweep" : " sweeps");
  const bool nothing_moved = std::all_of(history.begin(), history.end(),
                                         [](const auto& record) { return record.moved == 0; });
  if (nothing_moved) return sweeps + " found no vertex to move.";
  const double energy_before = evolve.before.figures.energy;
  const double energy_after = evolve.after.figures.energy;
  const double strain_before = report.unfold_before.strain.rms;
  const double strain_after = report.unfold.strain.rms;
  const std::string energy = energy_phrase(energy_before, energy_after);
  const std::string strain = strain_phrase(strain_before, strain_after);
  const bool apart = (energy_after < energy_before && strain.starts_with("raised")) ||
                     (energy_after > energy_before && strain.starts_with("lowered"));
  return sweeps + " " + energy + (apart ? " but " : " and ") + strain +
         "; no vertex moved further than " + significant_text(evolve.deviation.max, 2) + " " +
         std::string(to_string(report.unfold.unit)) + ".";
}

/// Whether a designer would take the form; empty where it is as it came.
std::string form_sentence(const FlattenReport& report) {
  const Fairness& fairness = report.evolve.fairness;
  if (fairness.unchanged) return {};
  if (fairness.is_smooth()) {
    return fairness.keeps_form() ? " The form stayed smooth."
                                 : " The form stayed smooth, but much of its curvature is gone.";
  }
  if (!fairness.bending_ratio) return " The form was a plane, and is bent now.";
  std::string text = " The form is crumpled: it is bent " +
                     significant_text(*fairness.bending_ratio, 2) + " times as much as it was";
  if (fairness.sharpest_fold) {
    text += ", and the sharpest new fold has " +
            significant_text(fairness.sharpest_fold->degrees, 2) + "°";
  }
  return text + ".";
}

}  // namespace

std::string unit_question(const UnfoldReport& unfold) {
  constexpr double smallest = 5.0, largest = 50000.0;  // millimetres that anyone cuts
  const double size =
      millimetres_per(unfold.unit) * std::max(unfold.pattern.width, unfold.pattern.height);
  if (size >= smallest && size <= largest) return {};
  return "The pattern is " + significant_text(size, 2) + " mm long: is the model's unit really " +
         std::string(to_string(unfold.unit)) + "?";
}

std::string verdict_text(const FlattenReport& report) {
  std::string text = state_sentence(report) + " " + effort_sentence(report) + form_sentence(report);
  if (!report.unfold.pattern.converged) {
    text += " Unfolding stopped before it was done: the strain may be more than it need be.";
  }
  const std::string question = unit_question(report.unfold);
  return question.empty() ? text : text + " " + question;
}

std::string border_text(const FlattenReport& report) {
  const auto& obstruction = report.evolve.before.obstruction;
  if (!obstruction || !obstruction->is_notable()) return {};
  return std::string(obstruction->has_flat_border()
                         ? "The edge lies in a plane and only a plane piece fits it: "
                         : "The edge is too short for so much surface: ") +
         "at least " + percent_text(obstruction->excess_share) +
         " of the area as it came must go for a piece with this edge to lie flat, so put in a dart "
         "or a cut to keep the form.";
}

}  // namespace planish
