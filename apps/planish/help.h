#pragma once

#include <string>

#include "shell/command.h"

namespace planish::cli {

/// What the program does and its verbs.
std::string program_help();

/// A verb's usage, flags and examples.
std::string verb_help(const Command& command);

/// What to type, for those who typed nothing.
std::string short_help();

}  // namespace planish::cli
