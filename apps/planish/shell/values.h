#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <planish/core/range.h>
#include <planish/io/read_features.h>

namespace planish::cli {

/// The shortest digits that read back to the same number: "0.5".
std::string shortest(double value);

/// The same, but whole numbers without an exponent: "10000000".
std::string plain(double value);

/// The whole number that the value of a flag is or says.
/// @throws UsageError where it is none, Error option_out_of_range
int whole_number_of(const std::string& flag, const Field& field, Range range);

/// The one of the known names that the text is, in capitals or not.
/// @throws UsageError that says which names there are and which is near
std::string known_name(const std::string& what, const std::string& text,
                       std::span<const std::string> known);

/// The names of enumerators.
template <class Values>
std::vector<std::string> names_of(const Values& values) {
  std::vector<std::string> names;
  names.reserve(values.size());
  for (const auto value : values)
    names.emplace_back(to_string(value));
  return names;
}

/// The enumerator that the text names, in capitals or not.
/// @throws UsageError as known_name()
template <class Values>
typename Values::value_type value_named(const std::string& what, const std::string& text,
                                        const Values& values) {
  const std::string name = known_name(what, text, names_of(values));
  return *std::find_if(values.begin(), values.end(),
                       [&](const auto value) { return to_string(value) == name; });
}

/// "a, b or c"
std::string list_of(std::span<const std::string> names);

/// "a, b, c and 38 more": the first eight.
std::string list_of_some(std::span<const std::string> names);

}  // namespace planish::cli
