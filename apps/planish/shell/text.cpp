#include "shell/text.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace planish::cli {

namespace {

std::string printed(const char* format, int precision, double value) {
  char buffer[400];  // 1e308 has 309 digits before the point
  const int length = std::snprintf(buffer, sizeof buffer, format, precision, value);
  return {buffer, static_cast<std::size_t>(length)};
}

/// By its power of ten, as in "2e-06".
std::string power_number(double value) {
  std::string text = printed("%#.*g", 1, value);  // "2.e-06"
  const std::size_t point = text.find(".e");
  if (point != std::string::npos) text.erase(point, 1);
  return text;
}

/// Large numbers have an exponent from here on.
constexpr double k_least_power = 1e6;

}  // namespace

std::string wrapped(std::string_view text, std::size_t indent) {
  std::string result;
  std::size_t column = indent;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, length);
    text.remove_prefix(std::min(length + 1, text.size()));
    if (column > indent && column + 1 + word.size() > k_text_width) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    }
    if (column > indent) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
  }
  return result;
}

std::string digits(double value, int significant) {
  std::string text = printed("%#.*g", significant, value);
  const bool is_large = text.find("e+") != std::string::npos;
  if (is_large && std::abs(value) < k_least_power) return fixed(value, 0);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string fixed(double value, int decimals) {
  return printed("%.*f", decimals, value);
}

std::string percent(double share) {
  constexpr double not_measurable = 1e-6;  // of strain, as everywhere
  if (std::abs(share) < not_measurable) return "0 %";
  const double value = 100.0 * share;
  if (std::abs(value) < 0.01) return digits(value, 2) + " %";
  return fixed(value, std::abs(value) < 10.0 ? 2 : 1) + " %";
}

std::string short_number(double value) {
  const double size = std::abs(value);
  if (value == 0.0) return "0";
  if (size < 0.00095 || size >= 99'999.5) return power_number(value);
  return size >= 999.5 ? fixed(value, 0) : digits(value, 3);
}

std::string shorter_number(double value) {
  const double size = std::abs(value);
  if (size >= 99'999.5) return power_number(value);
  return fixed(value, size < 0.00095  ? 2
                      : size < 0.0095 ? 3
                      : size < 9.95   ? 2
                      : size < 99.5   ? 1
                                      : 0);
}

std::string left(std::string text, std::size_t width) {
  if (text.size() < width) text.resize(width, ' ');
  return text;
}

std::string right(const std::string& text, std::size_t width) {
  return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}

std::string beginning(const std::string& text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  std::size_t end = bytes;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
    --end;  // what goes on a letter of several bytes
  return text.substr(0, end);
}

std::ostream& operator<<(std::ostream& out, Shown shown) {
  unsigned char before = 0;
  for (const char c : shown.text) {
    const auto byte = static_cast<unsigned char>(c);
    // In UTF-8 the control characters from U+0080 to U+009F are 0xC2 and one byte.
    const bool is_control = (byte < 0x20 && c != '\n' && c != '\t') || byte == 0x7F ||
                            (before == 0xC2 && byte >= 0x80 && byte < 0xA0);
    out.put(is_control ? '?' : c);
    before = byte;
  }
  return out;
}

std::string counted(std::size_t count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

}  // namespace planish::cli
