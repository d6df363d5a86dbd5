#pragma once

#include <string>

#include "shell/command.h"

namespace planish::cli {

/// The manual page of the program, planish(1), as roff.
std::string program_manual();

/// That of a verb with all of its flags: planish-flatten(1).
std::string verb_manual(const Command& command);

}  // namespace planish::cli
