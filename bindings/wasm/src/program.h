#pragma once

#include <functional>
#include <string>
#include <vector>

#include <planish/core/context.h>

namespace planish::wasm {

/// What a run of the program leaves, beside its files.
struct Run {
  int exit_code = 0;
  std::string out;  ///< what it printed
  std::string err;  ///< messages
};

/// The planish program. Never throws.
/// @param words the command line without the program's name
/// @param on_progress of long jobs; may be empty
Run run_program(const std::vector<std::string>& words,
                const std::function<void(const Progress&)>& on_progress);

}  // namespace planish::wasm
