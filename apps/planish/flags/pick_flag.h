#pragma once

#include <planish/flatten/flatten.h>

#include "shell/command.h"

namespace planish::cli {

/// --pick.
Flag pick_flag();

/// The options with the choice that --pick names, or as they are without it.
/// @throws UsageError for a number out of range, and beside flags that make the same choice
FlattenOptions picked(FlattenOptions options, const Arguments& arguments);

/// Ends with exit code 3 where evolving made the pattern worse, so that the design's was written.
CommandResult with_design_checked(CommandResult outcome, const FlattenReport& report);

}  // namespace planish::cli
