#pragma once

#include <string>

#include "shell/command.h"

namespace planish::cli {

/// What the program does and its verbs.
std::string program_help();

/// A verb's usage, flags and examples.
/// @param all false: those flags only that come first, where the verb marks any
std::string verb_help(const Command& command, bool all);

/// What to type, for those who typed nothing.
std::string short_help();

}  // namespace planish::cli
