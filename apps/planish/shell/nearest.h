#pragma once

#include <span>
#include <string>
#include <string_view>

namespace planish::cli {

/// Whether two words are the same but for capitals.
bool same_word(std::string_view a, std::string_view b);

/// How many letters must be put in, taken out, changed or swapped with the next one, in either
/// case, to turn one word into the other.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// Which of the known words someone may have meant, as the end of a sentence: "; did you mean
/// --sweeps?". Empty where none is really near: a wrong hint is worse than none.
std::string nearest_hint(std::string_view word, std::span<const std::string> known);

}  // namespace planish::cli
