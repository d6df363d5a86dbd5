#include <charconv>
#include <cmath>
#include <cstddef>
#include <utility>

#include <planish/flatten/flatten.h>

namespace planish {

namespace {

constexpr int k_flat = k_candidates;
constexpr const char* k_name_of_design = "as designed";

void check_preset(int number) {
  check_range("pick", number, {1.0, static_cast<double>(k_candidates)});
}

/// In per cent with at most three digits: "0.5 %".
std::string short_percent(double share) {
  char digits[32];
  const auto end =
      std::to_chars(digits, digits + sizeof digits, 100.0 * share, std::chars_format::general, 3)
          .ptr;
  return std::string(digits, end) + " %";
}

std::string rms_name(double strain) {
  return short_percent(strain) + " rms";
}

/// Auto with its other options as they are.
Auto auto_of(const FlattenOptions& given, Prefer prefer) {
  const auto* method = given.method ? std::get_if<Auto>(&*given.method) : nullptr;
  Auto options = method != nullptr ? *method : given.as_needed;
  options.prefer = prefer;
  options.limits = {};
  return options;
}

/// The limit of rms strain of a run of Auto, 0 where it goes on to flattenable. Without limits a
/// smooth surface has the default one.
double rms_limit_of(const Auto& options) {
  const bool has_default = options.prefer == Prefer::smooth && !options.limits.of_form().any();
  return has_default ? k_unmeasurable_strain : options.limits.rms;
}

/// Whether the pattern is strained as little as was asked for; within a tolerance, by as much as
/// that leaves.
bool keeps_limits(const FlattenReport& report) {
  if (!report.unfold.limits.empty()) return all_kept(report.unfold.limits);
  const Auto* options = report.evolve.auto_options();
  if (options == nullptr || options->prefer != Prefer::smooth) return true;
  return report.evolve.result.stop == StopReason::strain_met || !std::isinf(options->max_deviation);
}

Candidate design_of(const FlattenReport& report) {
  return {.method = report.evolve.method.value_or(Auto{}),
          .preset = 1,
          .stop = StopReason::design_kept,
          .strain = report.design_pattern.strain,
          .limits_kept = all_kept(report.design_pattern.limits),
          .flattenable = report.evolve.before.flattenable,
          .fairness = fairness_of_design(report.evolve.fairness)};
}

Candidate result_of(const FlattenReport& report) {
  const EvolveReport& evolve = report.evolve;
  return {.method = *evolve.method,
          .preset = preset_of(*evolve.method),
          .stop = evolve.result.stop,
          .sweeps = evolve.result.history.size(),
          .seconds = evolve.result.seconds,
          .strain = report.unfold.strain,
          .limits_kept = keeps_limits(report),
          .deviation = evolve.deviation,
          .flattenable = evolve.after.flattenable,
          .fairness = evolve.fairness};
}

}  // namespace

std::optional<int> preset_of(const Method& method) {
  const auto* options = std::get_if<Auto>(&method);
  if (options == nullptr || options->limits.both_ways() > 0.0) return std::nullopt;
  if (options->prefer == Prefer::flat) return k_flat;
  if (options->prefer != Prefer::smooth) return std::nullopt;
  for (std::size_t k = 0; k < k_candidate_strains.size(); ++k) {
    if (rms_limit_of(*options) == k_candidate_strains[k]) return static_cast<int>(k) + 2;
  }
  return std::nullopt;
}

FlattenOptions preset_options(int number, FlattenOptions options) {
  check_preset(number);
  options.method = auto_of(options, number == k_flat ? Prefer::flat : Prefer::smooth);
  options.keep_design = number == 1;
  if (!options.keep_design) options.limits = {};
  if (number > 1 && number < k_flat - 1)
    options.limits.rms = k_candidate_strains[static_cast<std::size_t>(number) - 2];
  return options;
}

std::vector<Candidate> FlattenReport::candidates() const {
  std::vector<Candidate> all = {design_of(*this)};
  if (!evolve.fairness.unchanged) all.push_back(result_of(*this));
  return all;
}

std::string preset_name(int number) {
  check_preset(number);
  if (number == 1) return k_name_of_design;
  if (number == k_flat) return "flat";
  return rms_name(k_candidate_strains[static_cast<std::size_t>(number) - 2]);
}

std::string candidate_name(const Candidate& candidate) {
  if (candidate.is_design()) return k_name_of_design;
  const auto* options = std::get_if<Auto>(&candidate.method);
  if (options == nullptr) return std::string(name_of(candidate.method));
  const std::string end = candidate.limits_kept ? "" : ", missed";
  if (const double limit = options->limits.both_ways(); limit > 0.0)
    return "limit " + short_percent(limit) + end;
  const double rms = rms_limit_of(*options);
  if (rms > 0.0) return rms_name(rms) + end;
  return candidate.flattenable ? "flat" : "as flat as it gets";
}

}  // namespace planish
