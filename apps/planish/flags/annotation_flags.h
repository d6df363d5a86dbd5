#pragma once

#include <planish/pattern/pattern_options.h>

#include "shell/command.h"

namespace planish::cli {

/// Allowance, notches, grain, marks and labels, for verbs that write patterns.
FlagGroup annotation_flags();

/// What the flags and their files ask for.
/// @param writes_sheet whether a pattern is drawn at all
/// @throws UsageError, Error option_out_of_range, and as read_notches() and read_marks()
PatternOptions annotations_from(const Arguments& arguments, bool writes_sheet);

}  // namespace planish::cli
