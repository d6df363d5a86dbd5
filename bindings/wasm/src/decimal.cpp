#include "decimal.h"

#include <cmath>
#include <cstdio>
#include <limits>

#include <fast_float/fast_float.h>

namespace planish {

namespace {

/// Digits, the first one not 0 unless the number is, and the power of ten of the first one.
struct Decimal {
  std::string digits;
  int power = 0;
};

std::string printed(const char* format, int precision, double value) {
  std::string text(32, '\0');
  for (;;) {
    const int length = std::snprintf(text.data(), text.size(), format, precision, value);
    if (static_cast<std::size_t>(length) < text.size())
      return text.substr(0, static_cast<std::size_t>(length));
    text.resize(static_cast<std::size_t>(length) + 1);
  }
}

/// The decimal number with this many digits that is nearest to the value.
Decimal nearest_decimal(double magnitude, int digits) {
  const std::string text = printed("%.*e", digits - 1, magnitude);
  const std::size_t e = text.find('e');
  Decimal decimal;
  for (const char letter : text.substr(0, e)) {
    if (letter != '.') decimal.digits += letter;
  }
  for (const char letter : text.substr(e + 2))
    decimal.power = 10 * decimal.power + (letter - '0');
  if (text[e + 1] == '-') decimal.power = -decimal.power;
  return decimal;
}

/// The next larger one of as many digits.
Decimal next_decimal(Decimal decimal) {
  std::size_t i = decimal.digits.size();
  while (i > 0 && decimal.digits[i - 1] == '9')
    decimal.digits[--i] = '0';
  if (i > 0) {
    ++decimal.digits[i - 1];
  } else {
    decimal.digits.front() = '1';
    ++decimal.power;
  }
  return decimal;
}

template <typename Number>
bool reads_back(const Decimal& decimal, Number magnitude) {
  const std::string text = decimal.digits.substr(0, 1) + "." + decimal.digits.substr(1) + "e" +
                           std::to_string(decimal.power);
  Number read = 0;
  fast_float::from_chars(text.data(), text.data() + text.size(), read);
  return read == magnitude;
}

Decimal without_zeros(Decimal decimal) {
  while (decimal.digits.size() > 1 && decimal.digits.back() == '0')
    decimal.digits.pop_back();
  return decimal;
}

/// Between digits10 digits, which every normal number gives back that was read from as many, and
/// max_digits10, which give back every number.
template <typename Number>
Decimal shortest(Number magnitude) {
  using Limits = std::numeric_limits<Number>;
  int digits = magnitude < Limits::min() ? 1 : Limits::digits10;
  for (; digits < Limits::max_digits10; ++digits) {
    const Decimal nearest = nearest_decimal(static_cast<double>(magnitude), digits);
    if (reads_back(nearest, magnitude)) return without_zeros(nearest);
    // Numbers below a power of two are half as far apart as those above: what is nearest may be too
    // far below, and the next decimal above near enough.
    int exponent = 0;
    if (std::frexp(magnitude, &exponent) != Number(0.5)) continue;
    const Decimal above = next_decimal(nearest);
    if (reads_back(above, magnitude)) return without_zeros(above);
  }
  return without_zeros(nearest_decimal(static_cast<double>(magnitude), digits));
}

std::string scientific(const Decimal& decimal) {
  const int power = std::abs(decimal.power);
  std::string text = decimal.digits.substr(0, 1);
  if (decimal.digits.size() > 1) text += "." + decimal.digits.substr(1);
  text += decimal.power < 0 ? "e-" : "e+";
  return text + (power < 10 ? "0" : "") + std::to_string(power);
}

/// A whole number beyond the digits that tell it from its neighbours has all its own digits.
std::string fixed(const Decimal& decimal, double magnitude) {
  const auto count = static_cast<int>(decimal.digits.size());
  if (decimal.power < 0)
    return "0." + std::string(static_cast<std::size_t>(-decimal.power - 1), '0') + decimal.digits;
  if (decimal.power + 1 >= count) return printed("%.*f", 0, magnitude);
  const auto whole = static_cast<std::size_t>(decimal.power + 1);
  return decimal.digits.substr(0, whole) + "." + decimal.digits.substr(whole);
}

template <typename Number>
std::string in_format(Number value, std::chars_format format) {
  const Number magnitude = std::abs(value);
  const std::string sign = std::signbit(value) ? "-" : "";
  if (!std::isfinite(value)) return sign + (std::isnan(value) ? "nan" : "inf");
  const Decimal decimal = magnitude == 0 ? Decimal{"0", 0} : shortest(magnitude);
  const bool asks_for_fixed = format == std::chars_format::fixed;
  const bool is_usual = decimal.power >= -4 && decimal.power < 6;
  if (asks_for_fixed || (format == std::chars_format::general && is_usual))
    return sign + fixed(decimal, static_cast<double>(magnitude));
  return sign + scientific(decimal);
}

template <typename Number>
std::string in_shorter_format(Number value) {
  const Number magnitude = std::abs(value);
  const std::string sign = std::signbit(value) ? "-" : "";
  if (!std::isfinite(value)) return sign + (std::isnan(value) ? "nan" : "inf");
  const Decimal decimal = magnitude == 0 ? Decimal{"0", 0} : shortest(magnitude);
  const std::string with_power = scientific(decimal);
  // Fixed is as long as its zeros at least.
  if (std::abs(decimal.power) > 40) return sign + with_power;
  const std::string whole = fixed(decimal, static_cast<double>(magnitude));
  return sign + (whole.size() <= with_power.size() ? whole : with_power);
}

}  // namespace

std::string shortest_decimal(double value) {
  return in_shorter_format(value);
}

std::string shortest_decimal(float value) {
  return in_shorter_format(value);
}

std::string shortest_decimal(double value, std::chars_format format) {
  return in_format(value, format);
}

std::string shortest_decimal(float value, std::chars_format format) {
  return in_format(value, format);
}

std::string rounded_decimal(double value, std::chars_format format, int precision) {
  if (!std::isfinite(value)) return in_format(value, format);
  return printed(format == std::chars_format::fixed        ? "%.*f"
                 : format == std::chars_format::scientific ? "%.*e"
                                                           : "%.*g",
                 precision, value);
}

}  // namespace planish
