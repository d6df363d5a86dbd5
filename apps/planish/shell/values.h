#pragma once

#include <span>
#include <string>
#include <string_view>

#include <planish/core/range.h>

namespace planish::cli {

/// The shortest digits that read back to the same number: "0.5".
std::string shortest(double value);

/// The same, but whole numbers without an exponent: "10000000".
std::string plain(double value);

/// The whole number that the value of a flag says.
/// @throws UsageError where it is none, Error option_out_of_range
int whole_number_of(const std::string& flag, const std::string& text, Range range);

/// The one of the known names that the text is, in capitals or not.
/// @throws UsageError that says which names there are and which is near
std::string known_name(const std::string& what, const std::string& text,
                       std::span<const std::string> known);

/// "a, b or c"
std::string list_of(std::span<const std::string> names);

}  // namespace planish::cli
