#pragma once

#include <vector>

#include <planish/evolve/evolve.h>
#include <planish/flatten/compare.h>

#include "shell/command.h"

namespace planish::cli {

/// All that there are.
std::vector<std::string> method_names();

/// --method, the flags of Stopping and those of every method, as their describe() has them; with
/// max_strain also --material.
/// @param standard the verb's own method, which comes first
std::vector<FlagGroup> method_flags(const Method& standard);

/// The method that the flags ask for, by its name or as the verb's own. Lengths are converted by
/// --unit.
/// @throws UsageError for unknown names, bad values and flags of another method; Error
///   option_out_of_range
Method method_from(const Arguments& arguments, const Method& standard);

/// When the flags ask to stop; the method's usual stopping where they do not say. Throws as
/// method_from().
Stopping stopping_from(const Arguments& arguments, const Method& method);

/// --remesh, for verbs that evolve one patch.
Flag remesh_flag();

/// --smooth-first, for verbs that evolve.
Flag smooth_first_flag();

/// Its length in model units, 0 without it.
/// @throws UsageError also where another flag does not go with it
double smooth_first_from(const Arguments& arguments);

/// --methods and the flags of Stopping, which hold for all methods.
FlagGroup compare_flags();

/// The word for all methods.
inline constexpr const char* k_all_methods = "all";

/// Whether --methods says so, or is not there.
bool asks_for_all_methods(const Arguments& arguments);

/// Whether --methods says "none", as it may where others take part.
bool asks_for_no_method(const Arguments& arguments);

/// The methods that --methods names, in its order, or all; each with its usual stopping but for
/// what the flags say.
/// @throws UsageError for names that are unknown or come twice, bad values; Error
///   option_out_of_range
std::vector<CompareRun> runs_from(const Arguments& arguments);

}  // namespace planish::cli
