#pragma once

#include <span>
#include <vector>

#include <planish/unfold/strain.h>

#include "shell/command.h"

namespace planish::cli {

/// --max-strain, --material and --max-rms-strain, of verbs that lay a patch flat as it is.
std::vector<Flag> limit_flags();

/// What they say: --max-strain 5% is for every edge, 5%@p99 for 99 % of the area, --material what
/// the material takes.
/// @throws UsageError where one is no share of length above 0, or --material and --max-strain are
/// both there
StrainLimits limits_from(const Arguments& arguments);

/// Ends with exit code 3 where a limit is not kept.
CommandResult with_limits_checked(CommandResult outcome, std::span<const LimitCheck> checks);

}  // namespace planish::cli
