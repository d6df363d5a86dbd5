#pragma once

#include <vector>

#include "shell/command.h"

namespace planish::cli {

Command flatten_command();
Command app_command();
Command measure_command();
Command evolve_command();
Command unfold_command();
Command compare_command();
Command frontier_command();
Command suggest_cuts_command();
Command panels_command();
Command carry_command();
Command collect_command();
Command convert_command();
Command sample_command();
Command materials_command();
Command describe_command();
Command completion_command();
Command man_command();
Command doctor_command();

/// All verbs, in the order of the help.
const std::vector<Command>& commands();

}  // namespace planish::cli
