#pragma once

#include <string>

namespace planish::cli {

// Scripts that let a shell complete verbs, flags and their values. They hold all that they offer,
// as a shell would wait for a program at each key.

/// For bash 4.4 and later.
std::string bash_completion();
std::string zsh_completion();
/// For fish 3.1 and later.
std::string fish_completion();

}  // namespace planish::cli
