#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>

#include <planish/flatten/compare.h>

#include "flatten/verdict.h"

namespace planish {

namespace {

constexpr double k_same = 0.02;              // relative changes up to this are none
constexpr double k_no_strain_change = 1e-6;  // nor are strains below this
constexpr double k_needle = 1.0;             // degrees: smaller angles spoil later work

double degrees(double radians) {
  return 180.0 / std::numbers::pi * radians;
}

std::string digits(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 2).ptr};
}

std::string percent(double share) {
  return digits(100.0 * share) + " %";
}

std::string unsmooth_text(const Fairness& fairness) {
  const std::string word(smoothness_word(fairness));
  if (!fairness.bending_ratio) return word + " (it was a plane)";
  return word + " (bent " + digits(*fairness.bending_ratio) + " times as much, " +
         percent(fairness.sharp_share) + " of it sharply)";
}

/// What a run paid with, if anything: what makes its result unfit although its figures look well.
std::string price(const CompareReport& report, const ComparedMethod& method) {
  const Flattenability& before = report.before.figures;
  const Flattenability& after = method.evolve->after.figures;
  std::string text;
  const auto add = [&text](const std::string& words) {
    text += (text.empty() ? "" : ", ") + words;
  };
  const double angle = degrees(after.min_angle);
  if (angle < k_needle && after.min_angle < 0.5 * before.min_angle) {
    add("needles (" + digits(angle) + " deg)");
  }
  const Fairness& fairness = method.evolve->fairness;
  if (!fairness.is_smooth()) add(unsmooth_text(fairness));
  if (method.unfold && report.design_least_stretch) {
    if (method.unfold->pattern.overlaps && !report.design_least_stretch->pattern.overlaps) {
      add("pattern overlaps");
    }
    if (method.unfold->pattern.flipped_triangles > 0) add("flipped triangles");
  }
  return text;
}

/// Strain or, without patterns, the curvature that is left.
struct Measure {
  double before = 0.0, after = 0.0;

  bool is_lower() const { return after < before - allowance(); }
  bool is_higher() const { return after > before + allowance(); }
  double allowance() const { return std::max(k_same * before, k_no_strain_change); }
};

Measure measure_of(const CompareReport& report, const ComparedMethod& method) {
  if (method.unfold && report.design_least_stretch) {
    return {report.design_least_stretch->strain.rms, method.unfold->strain.rms};
  }
  return {report.before.figures.sum_abs_defect, method.evolve->after.figures.sum_abs_defect};
}

std::string change_text(const Measure& measure, bool of_strain) {
  if (of_strain) {
    return "strain " + percent(measure.before) + " -> " + percent(measure.after);
  }
  return "curvature left " + digits(measure.before) + " -> " + digits(measure.after) + " rad";
}

std::string gain(const CompareReport& report, const ComparedMethod& method) {
  const EvolveReport& evolve = *method.evolve;
  const bool of_strain = method.unfold && report.design_least_stretch;
  const Measure measure = measure_of(report, method);
  const std::string thing = of_strain ? "pattern" : "patch";
  if (evolve.deviation.max == 0.0) return "moved nothing";
  if (evolve.after.flattenable) return "flattenable: " + change_text(measure, of_strain);
  if (measure.is_lower()) return "better " + thing + ": " + change_text(measure, of_strain);
  if (measure.is_higher()) return "worse " + thing + ": " + change_text(measure, of_strain);
  const double energy_before = report.before.figures.energy;
  const double energy_after = evolve.after.figures.energy;
  const std::string same = of_strain ? "strain" : "curvature left";
  if (energy_after < (1.0 - k_same) * energy_before) {
    return "no better " + thing + ": energy -" + percent(1.0 - energy_after / energy_before) +
           ", " + same + " as before";
  }
  return "no better " + thing + ": " + same + " as before";
}

}  // namespace

std::string verdict_text(const CompareReport& report, const ComparedMethod& method) {
  if (!method.evolve) return "failed: " + method.failure->message;
  std::string text = gain(report, method);
  const std::string paid = price(report, method);
  if (!paid.empty()) text += "; " + paid;
  if (method.failure) text += "; no pattern: " + method.failure->message;
  return text;
}

std::optional<std::size_t> best_run(const CompareReport& report) {
  std::optional<std::size_t> best;
  double least = 0.0;
  for (std::size_t i = 0; i < report.runs.size(); ++i) {
    const ComparedMethod& method = report.runs[i];
    if (method.failure || !price(report, method).empty()) continue;
    const Measure measure = measure_of(report, method);
    if (!measure.is_lower() || (best && measure.after >= least)) continue;
    best = i;
    least = measure.after;
  }
  return best;
}

}  // namespace planish
