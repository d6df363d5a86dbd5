#pragma once

#include <charconv>
#include <string>

namespace planish {

/// Appends the shortest digits that read back to the same double; the same in every locale.
inline void append_number(std::string& text, double value) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
  text.append(digits, end);
}

/// Appends at most `decimals` digits after the point, without trailing zeros and without "-0".
inline void append_fixed(std::string& text, double value, int decimals) {
  char digits[400];  // 1e308 has 309 digits before the point
  auto* end =
      std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, decimals).ptr;
  if (decimals > 0) {
    while (end[-1] == '0')
      --end;
    if (end[-1] == '.') --end;
  }
  const bool minus_zero = end == digits + 2 && digits[0] == '-' && digits[1] == '0';
  text.append(minus_zero ? digits + 1 : digits, end);
}

inline std::string number_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

inline std::string fixed_text(double value, int decimals) {
  std::string text;
  append_fixed(text, value, decimals);
  return text;
}

}  // namespace planish
