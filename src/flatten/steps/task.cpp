#include "flatten/steps/task.h"

#include <cmath>

namespace planish {

namespace {

Method method_of(const FlattenOptions& options) {
  return options.method.value_or(options.as_needed);
}

/// Auto ends when its estimate of the strain keeps its limits.
Method with_limits(Method method, const StrainLimits& limits) {
  auto* options = std::get_if<Auto>(&method);
  if (options == nullptr) return method;
  StrainLimits& own = options->limits = options->limits.of_form();
  if (own.max == 0.0) own.max = limits.both_ways();
  if (own.rms == 0.0) own.rms = limits.rms;
  return method;
}

StrainLimits aim_of(const StrainLimits& limits, const Method& method, const Stopping& stopping) {
  const auto* options = std::get_if<Auto>(&method);
  const bool goes_on = stopping.target_e_max > 0.0;
  if (options == nullptr || goes_on || options->prefer == Prefer::flat) return {};
  if (limits.any() || options->prefer == Prefer::near) return limits;
  return {.rms = k_unmeasurable_strain};
}

}  // namespace

StrainLimits limits_of(const FlattenOptions& options) {
  if (options.limits.any()) return options.limits;
  const Method method = method_of(options);
  const auto* as_auto = std::get_if<Auto>(&method);
  if (as_auto == nullptr) return {};
  return as_auto->limits;
}

Task::Task(const FlattenOptions& asked, const SearchEffort& effort_of_searches)
    : options(asked),
      effort(effort_of_searches),
      limits(limits_of(asked)),
      method(with_limits(method_of(asked), limits)),
      stopping(asked.stopping.value_or(usual_stopping(method))),
      aim(aim_of(limits, method, stopping)) {}

std::optional<double> Task::tolerance() const {
  const Auto* how = auto_options();
  const bool is_led = how == nullptr || how->prefer != Prefer::smooth || how->max_bending > 0.0 ||
                      !aim.any() || (options.method && !options.limits.any());
  if (is_led || std::isinf(how->max_deviation)) return std::nullopt;
  return how->max_deviation;
}

bool Task::seeks_least_change() const {
  const Auto* how = auto_options();
  return how != nullptr && how->prefer == Prefer::smooth && std::isinf(how->max_deviation) &&
         aim.any() && (options.limits.bounds_edges() || (options.limits.any() && !options.method));
}

Method Task::tightened(Method of_last_run, double factor) const {
  constexpr double surely = 0.98;
  StrainLimits& own = std::get<Auto>(of_last_run).limits;
  if (!own.any()) own.rms = aim.rms;
  own.max *= surely * factor;
  own.rms *= surely * factor;
  return of_last_run;
}

}  // namespace planish
