#pragma once

#include <span>
#include <string>
#include <string_view>

namespace planish::cli {

/// How many letters must be put in, taken out, changed or swapped with the next one, in either
/// case, to turn one word into the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Which of the known words someone may have meant, as the end of a sentence: "; did you mean
/// --sweeps?" or, where none is close, "; the nearest is --unit". Empty without known words.
std::string nearest_hint(std::string_view word, std::span<const std::string> known);

}  // namespace planish::cli
