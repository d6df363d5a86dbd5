#include "flags/limit_flags.h"

#include <string>

#include <planish/measure/material.h>

#include "flags/material_flag.h"
#include "flags/quantities.h"
#include "flatten/strain_limit_text.h"
#include "shell/failures.h"
#include "shell/run_context.h"

namespace planish::cli {

namespace {

constexpr std::string_view k_area_suffix = "@p99";
constexpr Range k_strain = {0.0, k_largest_strain_limit};

double share_above_0(const std::string& flag, const Field& field, const Arguments& arguments) {
  const double share = quantity_value(flag, field, Quantity::share, k_strain, arguments);
  if (share == 0.0) {
    throw Error(ErrorCode::option_out_of_range,
                flag + " is 0 but must be more: leave it out for no limit");
  }
  return share;
}

}  // namespace

std::vector<Flag> limit_flags() {
  return {{"--max-strain",
           "X",
           "largest change of an edge's length from the patch to the pattern (0.02 or 2%); 2%@p99: "
           "on 99 % of the area",
           0,
           false,
           {.type = ValueType::share, .range = k_strain}},
          material_flag(),
          {"--max-rms-strain",
           "X",
           "largest root mean square of the strain (0.02 or 2%)",
           0,
           false,
           {.type = ValueType::share, .range = k_strain}}};
}

StrainLimits limits_from(const Arguments& arguments) {
  StrainLimits limits;
  if (const auto material = material_from(arguments)) limits = limits_of(*material);
  if (arguments.has("--max-strain")) {
    Field share = arguments.value("--max-strain");
    auto* const text = std::get_if<std::string>(&share);
    const std::size_t at = text == nullptr ? std::string::npos : text->find('@');
    const bool is_of_area = at != std::string::npos;
    if (is_of_area && std::string_view(*text).substr(at) != k_area_suffix) {
      throw UsageError("--max-strain is \"" + *text +
                       "\" but must be for every edge, as 5%, or for 99 % of the area, as 5%@p99");
    }
    if (is_of_area) text->resize(at);
    (is_of_area ? limits.p99 : limits.max) = share_above_0("--max-strain", share, arguments);
  }
  if (arguments.has("--max-rms-strain")) {
    limits.rms = share_above_0("--max-rms-strain", arguments.value("--max-rms-strain"), arguments);
  }
  return limits;
}

CommandResult with_limits_checked(CommandResult outcome, std::span<const LimitCheck> checks) {
  if (all_kept(checks) || outcome.exit_code != k_exit_done) return outcome;
  outcome.exit_code = k_exit_target_missed;
  for (const LimitCheck& check : checks) {
    if (check.met) continue;
    outcome.complaint += (outcome.complaint.empty() ? "" : " ") + strain_limit_text(check);
  }
  return outcome;
}

}  // namespace planish::cli
