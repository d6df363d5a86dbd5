#include "flatten/steps/aim.h"

namespace planish {

Method how_of(const FlattenOptions& options) {
  return options.method.value_or(options.as_needed);
}

StrainLimits limits_of(const FlattenOptions& options) {
  if (options.limits.any()) return options.limits;
  const Method how = how_of(options);
  const auto* method = std::get_if<Auto>(&how);
  if (method == nullptr) return {};
  return {.max = method->max_strain, .rms = method->max_rms_strain};
}

StrainLimits aim_of(const StrainLimits& limits, const Method& method, const Stopping& stopping) {
  const auto* options = std::get_if<Auto>(&method);
  const bool goes_on = stopping.target_e_max > 0.0;
  if (options == nullptr || goes_on || options->prefer == Prefer::flat) return {};
  if (limits.any() || options->prefer == Prefer::near) return limits;
  return {.rms = k_unmeasurable_strain};
}

Method aimed_at(const StrainLimits& limits, Method method) {
  auto* options = std::get_if<Auto>(&method);
  if (options == nullptr) return method;
  if (options->max_strain == 0.0) options->max_strain = limits.both_ways();
  if (options->max_rms_strain == 0.0) options->max_rms_strain = limits.rms;
  return method;
}

Method tightened(Method method, const StrainLimits& aim, double share) {
  constexpr double surely = 0.98;
  auto& options = std::get<Auto>(method);
  if (options.max_strain == 0.0 && options.max_rms_strain == 0.0) options.max_rms_strain = aim.rms;
  options.max_strain *= surely * share;
  options.max_rms_strain *= surely * share;
  return method;
}

}  // namespace planish
