#pragma once

#include <string>
#include <string_view>

#include <planish/core/error.h>

namespace planish {

/// What goes on after an error, a sentence or two: names flags and verbs of the program, which are
/// keywords and functions elsewhere. Never empty.
std::string_view way_on(ErrorCode code);

/// What the error says, with its place, and the way on behind it.
std::string with_way_on(const Error& error);

}  // namespace planish
