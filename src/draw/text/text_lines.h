#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace planish {

/// How many letters a text has, or more where formats with Latin letters only spell it with more.
std::size_t letters_in(std::string_view text);

/// A text in lines of at most this number of letters, broken between its parts ("a · b"), or
/// between words where it has one part. What cannot be broken is longer.
std::vector<std::string> broken_lines(std::string_view text, std::size_t most_letters);

}  // namespace planish
