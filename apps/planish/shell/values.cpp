#include "shell/values.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "shell/failures.h"
#include "shell/nearest.h"

namespace planish::cli {

std::string shortest(double value) {
  char digits[32];
  return {digits, std::to_chars(digits, digits + sizeof digits, value).ptr};
}

std::string plain(double value) {
  const bool is_whole = std::abs(value) < 1e15 && value == std::trunc(value);
  return is_whole ? std::to_string(static_cast<long long>(value)) : shortest(value);
}

int whole_number_of(const std::string& flag, const std::string& text, Range range) {
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, value);
  if (parsed.ec == std::errc::result_out_of_range) {
    throw UsageError(flag + " is " + text + " but must be a smaller number");
  }
  if (parsed.ec != std::errc() || parsed.ptr != end) {
    throw UsageError(flag + " is \"" + text + "\" but must be a whole number");
  }
  check_range(flag, value, range);
  return value;
}

std::string known_name(const std::string& what, const std::string& text,
                       std::span<const std::string> known) {
  const auto found = std::find_if(known.begin(), known.end(),
                                  [&](const std::string& name) { return same_word(name, text); });
  if (found != known.end()) return *found;
  throw UsageError("unknown " + what + " " + text + nearest_hint(text, known) + " (there are " +
                   list_of(known) + ")");
}

std::string list_of(std::span<const std::string> names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " or " : ", ";
    text += names[i];
  }
  return text;
}

std::string list_of_some(std::span<const std::string> names) {
  constexpr std::size_t k_most = 8;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), k_most); ++i)
    text += (i > 0 ? ", " : "") + names[i];
  if (names.size() > k_most) text += " and " + std::to_string(names.size() - k_most) + " more";
  return text;
}

}  // namespace planish::cli
