#include "measure/cautions/decimal_digits.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <string_view>

namespace planish {

DecimalDigits decimal_digits(double number) {
  char text[32];
  const char* const end =
      std::to_chars(text, text + sizeof text, std::abs(number), std::chars_format::scientific).ptr;
  const std::string_view word(text, static_cast<std::size_t>(end - text));
  const std::size_t e = word.find('e');
  if (number == 0.0 || e == std::string_view::npos) return {};
  const std::size_t sign = word[e + 1] == '+' ? 1 : 0;
  DecimalDigits digits{e == 1 ? 1 : static_cast<int>(e) - 1, 0};
  std::from_chars(text + e + 1 + sign, end, digits.power);
  return digits;
}

bool is_text_of_float(double number, int digits) {
  if (!(std::abs(number) <= static_cast<double>(std::numeric_limits<float>::max()))) return false;
  const auto nearest = static_cast<float>(number);
  char text[32];
  const auto is_read = [&](const char* end) {
    double read = 0.0;
    std::from_chars(text, end, read);
    return read == number;
  };
  return is_read(std::to_chars(text, text + sizeof text, nearest).ptr) ||
         is_read(std::to_chars(text, text + sizeof text, static_cast<double>(nearest),
                               std::chars_format::general, digits)
                     .ptr);
}

bool fill_digits(std::span<const DecimalDigits> numbers, int digits) {
  struct Class {
    std::size_t all = 0, full = 0;
  };
  std::map<int, Class> classes;  // by powers of ten
  for (const DecimalDigits& number : numbers) {
    if (number.count == 0) continue;
    Class& found = classes[number.power];
    ++found.all;
    if (number.count == digits) ++found.full;
  }
  std::size_t filled = 0;
  for (const auto& [power, found] : classes) {
    if (found.all >= 3 && 2 * found.full >= found.all) ++filled;
  }
  return filled >= 2;
}

}  // namespace planish
