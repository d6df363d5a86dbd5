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

int whole_number_of(const std::string& flag, const Field& field, Range range) {
  const std::string text = field_text(field);
  const auto* const whole = std::get_if<std::int64_t>(&field);
  std::int64_t value = whole == nullptr ? 0 : *whole;
  bool is_whole = whole != nullptr, is_too_long = false;
  if (std::holds_alternative<std::string>(field)) {
    const char* const end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, value);
    is_too_long = parsed.ec == std::errc::result_out_of_range;
    is_whole = parsed.ec == std::errc() && parsed.ptr == end;
  }
  if (is_too_long || value != static_cast<int>(value)) {
    throw UsageError(flag + " is " + text + " but must be a smaller number");
  }
  if (!is_whole) {
    throw UsageError(flag + " is \"" + text + "\" but must be a whole number");
  }
  check_range(flag, static_cast<double>(value), range);
  return static_cast<int>(value);
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
