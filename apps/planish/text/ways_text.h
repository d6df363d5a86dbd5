#pragma once

#include <string>

#include <planish/flatten/flatten.h>

namespace planish::cli {

/// What taking less stretch would do to the form, a line for each limit that the design misses,
/// with the flag that asks for it; empty where none is known. At most 80 columns wide.
std::string ways_text(const FlattenReport& report);

}  // namespace planish::cli
