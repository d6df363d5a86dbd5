#pragma once

#include <span>
#include <string>
#include <vector>

#include "shell/command.h"

namespace planish::cli {

/// A command line taken apart, not yet looked into.
struct Parsed {
  const Command* command = nullptr;  ///< nullptr where no verb was given
  Arguments arguments;               ///< global flags among them
  std::vector<std::string> notes;    ///< what may not be meant: a flag with two values
};

/// Takes a command line apart. Asking for help or the version wins over every other fault.
/// @throws UsageError for unknown verbs and flags, naming one that is near, for flags without their
///   value and for a wrong number of operands
Parsed parse(std::span<const std::string> args);

/// Refuses empty texts, as a shell makes them of empty variables: they name no file and no number.
/// @throws UsageError
void refuse_empty_values(const Command& command, const Arguments& arguments);

/// True where the command line asks for the flag, whatever else is wrong with it.
bool asks_for(std::span<const std::string> args, std::string_view flag);

}  // namespace planish::cli
