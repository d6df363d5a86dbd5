#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "shell/command.h"

namespace planish::cli {

/// What a shell offers where a value is typed.
struct Candidates {
  enum class Kind {
    nothing,  ///< numbers and free text
    one,      ///< one of the words
    some,     ///< some of the words, with commas between them
    file,     ///< files whose names end on one of the words, and folders; all files without words
    folder,
  };
  Kind kind = Kind::nothing;
  std::vector<std::string> words = {};
};

/// For the value of a flag.
Candidates candidates_of(const Flag& flag);
/// For an operand of a verb.
Candidates candidates_of(const FlagValue& operand);

/// The flags of all groups, each name once. Where flags of several methods have one name, the
/// choices of all are there.
std::vector<Flag> distinct_flags(const std::vector<FlagGroup>& groups);

/// "--output" and "-o".
std::vector<std::string> offered_names(const Flag& flag);

/// The beginning of what the help says about a flag, without ranges and examples in parentheses.
std::string short_doc(const Flag& flag);

/// The words with the separator between them.
std::string joined(const std::vector<std::string>& words, std::string_view separator);

/// The text with a backslash before each of these characters.
std::string escaped(std::string_view text, std::string_view characters);

}  // namespace planish::cli
