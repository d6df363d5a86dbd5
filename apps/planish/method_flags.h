#pragma once

#include <vector>

#include <planish/evolve/evolve.h>
#include <planish/report/compare.h>

#include "command.h"

namespace planish::cli {

/// The default first.
std::vector<std::string> method_names();

/// --method, the flags of Stopping and those of every method, as their describe() has them.
std::vector<FlagGroup> method_flags();

/// The method that the flags ask for.
/// @throws UsageError for unknown names, bad values and flags of another method; Error
///   option_out_of_range
Method method_from(const Arguments& arguments);

/// When the flags ask to stop. Throws as method_from().
Stopping stopping_from(const Arguments& arguments);

/// --methods and the flags of Stopping, which hold for all methods.
FlagGroup compare_flags();

/// The methods that --methods names, in its order, or all; each with its usual stopping but for
/// what the flags say.
/// @throws UsageError for names that are unknown or come twice, bad values; Error
///   option_out_of_range
std::vector<CompareRun> runs_from(const Arguments& arguments);

}  // namespace planish::cli
