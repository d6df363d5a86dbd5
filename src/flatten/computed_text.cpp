#include <algorithm>
#include <cmath>
#include <string>

#include "core/figure_text.h"
#include "flatten/verdict.h"

namespace planish {

namespace {

// Relative changes below these are not worth a word.
constexpr double k_same_energy = 0.005, k_same_strain = 0.02;
constexpr double k_not_measurable = 1e-6;  // of strain: rounding

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

}  // namespace

std::string computed_text(const FlattenReport& report) {
  const EvolveReport& evolve = report.evolve;
  const auto& history = evolve.result.history;
  if (history.empty()) {
    return evolve.before.flattenable ? "It came so, and no vertex was moved."
                                     : "No sweep was made, and no vertex was moved.";
  }
  const std::string sweeps = count_text(history.size()) + " " + std::string(evolve.method_name()) +
                             (history.size() == 1 ? " sweep" : " sweeps");
  const bool nothing_moved = std::all_of(history.begin(), history.end(),
                                         [](const auto& record) { return record.moved == 0; });
  if (nothing_moved) return sweeps + " found no vertex to move.";
  const double energy_before = evolve.before.figures.energy;
  const double energy_after = evolve.after.figures.energy;
  const double strain_before = report.design_least_stretch.strain.rms;
  const double strain_after = report.unfold.strain.rms;
  const std::string energy = energy_phrase(energy_before, energy_after);
  const std::string strain = strain_phrase(strain_before, strain_after);
  const bool apart = (energy_after < energy_before && strain.starts_with("raised")) ||
                     (energy_after > energy_before && strain.starts_with("lowered"));
  return sweeps + " " + energy + (apart ? " but " : " and ") + strain + ".";
}

}  // namespace planish
