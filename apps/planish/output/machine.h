#pragma once

#include "shell/command.h"

namespace planish::cli {

/// --for: a name for values of several flags.
Flag machine_flag();

/// The arguments with the flags that --for stands for, but for those that are given themselves.
/// Formats join where the verb has --formats; flags about a format that is not written are left.
/// @param output of a verb without --formats: the file that it writes
/// @throws UsageError for unknown names, and where what is written is not for such a machine
Arguments with_machine(const Arguments& arguments, const std::string& output = {});

/// Whether --only-layers, if it is there, is what --for stands for.
bool has_layers_of_machine(const Arguments& arguments);

}  // namespace planish::cli
