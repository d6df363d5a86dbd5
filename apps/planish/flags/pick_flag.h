#pragma once

#include <planish/flatten/flatten.h>

#include "shell/command.h"

namespace planish::cli {

/// Whether the flags ask for another form, besides by limits of strain.
bool asks_to_evolve(const Arguments& arguments);

/// Tells of flags that say how to evolve where nothing asks for it.
void note_idle_evolve_flags(Session& session, const Arguments& arguments);

/// --pick.
Flag pick_flag();

/// The options with the choice that --pick names, or as they are without it.
/// @throws UsageError for a number out of range, and beside flags that make the same choice
FlattenOptions picked(FlattenOptions options, const Arguments& arguments);

/// Ends with exit code 3 where evolving made the pattern worse, so that the design's was written.
CommandResult with_design_checked(CommandResult outcome, const FlattenReport& report);

}  // namespace planish::cli
