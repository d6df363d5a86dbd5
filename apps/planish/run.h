#pragma once

#include <ostream>
#include <span>
#include <string>

#include "shell/run_context.h"

namespace planish::cli {

/// The planish program. Never throws.
/// @param args the command line without the program's name
/// @return the exit code
int run(std::span<const std::string> args, std::ostream& out, std::ostream& err,
        const RunContext& context = {});

}  // namespace planish::cli
