#include "flatten/limit_checks.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

#include "core/figure_text.h"
#include "flatten/strain_limit_text.h"

namespace planish {

namespace {

constexpr double k_degrees = 180.0 / std::numbers::pi;
constexpr double k_rounding = 1e-9;  // of a limit: positions are rounded as they are scaled

/// Of the options that this type has as numbers, the one of that name.
template <class Options>
std::optional<double> number_named(Options options, std::string_view name) {
  std::optional<double> number;
  describe(options, [&](std::string_view option, const auto& value, auto&&...) {
    if constexpr (std::is_same_v<std::decay_t<decltype(value)>, double>) {
      if (option == name) number = value;
    }
  });
  return number;
}

/// The value of an option that was given another one than it has unasked.
std::optional<double> given(const std::optional<Method>& method, std::string_view name) {
  if (!method) return std::nullopt;
  return std::visit(
      [&](const auto& options) -> std::optional<double> {
        const auto value = number_named(options, name);
        const auto usual = number_named(std::decay_t<decltype(options)>{}, name);
        return value == usual ? std::nullopt : value;
      },
      *method);
}

/// `near` has no bound of bending.
std::optional<double> given_bending(const EvolveReport& evolve) {
  const Auto* options = evolve.auto_options();
  if (options != nullptr && options->prefer == Prefer::near) return std::nullopt;
  return given(evolve.method, "max_bending");
}

}  // namespace

std::vector<LimitCheck> limit_checks(const EvolveReport& evolve) {
  std::vector<LimitCheck> checks;
  const auto at_most = [&](Criterion what, double limit, double value) {
    checks.push_back({what, limit, value, value <= limit * (1.0 + k_rounding)});
  };
  if (const auto limit = given(evolve.method, "max_deviation"))
    at_most(Criterion::deviation, *limit, evolve.deviation.max);
  if (const auto limit = given(evolve.method, "min_angle")) {
    const double before = k_degrees * evolve.before.figures.min_angle;
    const double after = k_degrees * evolve.after.figures.min_angle;
    const double bound = std::min(*limit, before);
    checks.push_back({Criterion::angle, *limit, after, after >= bound * (1.0 - k_rounding)});
  }
  if (const auto limit = given_bending(evolve); limit && evolve.fairness.bending_ratio)
    at_most(Criterion::bending, *limit, *evolve.fairness.bending_ratio);
  if (evolve.stopping.target_e_max > 0.0)
    at_most(Criterion::e_max, evolve.stopping.target_e_max, evolve.after.figures.e_max);
  return checks;
}

std::vector<LimitCheck> limit_checks(const FlattenReport& report) {
  std::vector<LimitCheck> checks = report.unfold.limits;
  const std::vector<LimitCheck> others = limit_checks(report.evolve);
  checks.insert(checks.end(), others.begin(), others.end());
  return checks;
}

std::string limit_text(const LimitCheck& check, Unit unit) {
  switch (check.what) {
    case Criterion::deviation:
      return "at most " + length_text(check.limit, unit, 3);
    case Criterion::angle:
      return "at least " + significant_text(check.limit, 3) + "°";
    case Criterion::e_max:
      return "at most " + significant_text(check.limit, 2) + " rad";
    case Criterion::bending:
      return "at most " + significant_text(check.limit, 3) + " times the design's";
    default:
      break;
  }
  if (!is_of_strain(check.what)) return {};  // no limit
  return "at most " + percent_text(check.limit) + side_words(check.what) + scope_words(check.what);
}

}  // namespace planish
