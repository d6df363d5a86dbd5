#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shell/command.h"

namespace planish::cli {

// What the help and the manual pages both say.

inline constexpr std::string_view k_program_summary =
    "makes curved patches flattenable and writes their true-size patterns";
inline constexpr std::string_view k_nothing_after_failure = "Nothing is written after a failure.";

struct ExitCode {
  int number = 0;
  std::string_view meaning;
};

std::span<const ExitCode> exit_codes();

/// Command lines to begin with.
std::vector<std::string> program_examples();

/// What the program does and its verbs.
std::string program_help();

/// A verb's usage, flags and examples.
/// @param all false: those flags only that come first, where the verb marks any
std::string verb_help(const Command& command, bool all);

/// What to type, for those who typed nothing.
std::string short_help();

}  // namespace planish::cli
