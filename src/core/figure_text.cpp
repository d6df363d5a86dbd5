#include "core/figure_text.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <string_view>

#include "core/math.h"

namespace planish {

namespace {

constexpr std::string_view k_minus = "\u2212";
constexpr std::string_view k_narrow_blank = "\u202F";
constexpr std::string_view k_blank = "\u00A0";  // keeps number and unit on one line

std::string digits_of(double value, std::chars_format format, int precision) {
  char digits[400];  // 1e308 has 309 digits before the point
  const auto end = std::to_chars(digits, digits + sizeof digits, value, format, precision).ptr;
  return {digits, end};
}

std::string with_true_minus(std::string text) {
  if (text.empty() || text.front() != '-') return text;
  const bool is_zero = text.find_first_of("123456789") == std::string::npos;
  return (is_zero ? std::string() : std::string(k_minus)) + text.substr(1);
}

std::string superscript(std::string_view number) {
  constexpr std::string_view digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char c : number)
    text += c == '-' ? std::string_view("⁻") : digits[c - '0'];
  return text;
}

double shown_per(Unit unit) {
  return unit == Unit::in ? 1.0 : millimetres_per(unit);
}

std::string shown_unit(Unit unit) {
  return std::string(k_blank) + (unit == Unit::in ? "in" : "mm");
}

std::string not_finite_text(double value) {
  return std::isnan(value) ? "not a number" : value > 0 ? "infinite" : "minus infinite";
}

}  // namespace

std::string significant_text(double value, int digits) {
  if (!std::isfinite(value)) return not_finite_text(value);
  if (value == 0.0) return "0";
  // Let the rounding decide the power: 0.09996 with three digits is 0.100.
  const std::string scientific = digits_of(value, std::chars_format::scientific, digits - 1);
  const std::size_t e = scientific.find('e');
  const char* power_end = scientific.data() + scientific.size();
  int power = 0;
  std::from_chars(scientific.data() + e + (scientific[e + 1] == '+' ? 2 : 1), power_end, power);
  if (power >= -4 && power < 6) {
    const int decimals = digits - 1 - power;
    return with_true_minus(digits_of(value, std::chars_format::fixed, decimals > 0 ? decimals : 0));
  }
  return with_true_minus(scientific.substr(0, e)) + std::string(k_blank) + "×" +
         std::string(k_blank) + power_of_ten_text(power);
}

std::string decimals_text(double value, int decimals) {
  if (!std::isfinite(value)) return not_finite_text(value);
  return with_true_minus(digits_of(value, std::chars_format::fixed, decimals));
}

std::string about_text(double value) {
  if (!std::isfinite(value) || std::abs(value) < 100.0) return significant_text(value, 2);
  const double unit =
      math::power_of_ten(static_cast<int>(std::floor(math::log10(std::abs(value)))) - 1);
  return significant_text(unit * std::round(value / unit), 2);
}

std::string percent_text(double fraction) {
  constexpr double least = 1e-6;
  if (fraction > 0.0 && fraction < least) return "under 0.0001" + std::string(k_blank) + "%";
  const double percent = 100.0 * fraction;
  const std::string number =
      std::abs(percent) >= 99.5 ? decimals_text(percent, 0) : significant_text(percent, 2);
  return std::isfinite(percent) ? number + std::string(k_blank) + "%" : number;
}

std::string signed_percent_text(double fraction) {
  return (fraction > 0.0 ? "+" : "") + percent_text(fraction);
}

std::string length_text(double length, Unit unit, int digits) {
  return significant_text(shown_per(unit) * length, digits) + shown_unit(unit);
}

std::string size_text(double width, double height, Unit unit) {
  return significant_text(shown_per(unit) * width) + " × " +
         significant_text(shown_per(unit) * height) + shown_unit(unit);
}

std::string power_of_ten_text(int power) {
  return "10" + superscript(std::to_string(power));
}

std::string count_text(std::size_t count) {
  std::string text = std::to_string(count);
  for (std::size_t place = text.size(); place > 3;) {
    place -= 3;
    text.insert(place, k_narrow_blank);
  }
  return text;
}

}  // namespace planish
