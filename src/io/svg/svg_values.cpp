#include "io/svg/svg_values.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fast_float/fast_float.h>

#include "core/math.h"

namespace planish {

namespace {

bool is_svg_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_svg_blank(text.front()))
    text.remove_prefix(1);
  while (!text.empty() && is_svg_blank(text.back()))
    text.remove_suffix(1);
  return text;
}

/// Sine and cosine of degrees, exact for quarters of a turn; not finite for very many turns.
math::SineCosine of_degrees(double degrees) {
  const double quarters = degrees / 90.0;
  if (quarters == std::floor(quarters) && std::abs(quarters) < 1e6) {
    const auto turn = static_cast<int>(std::fmod(std::fmod(quarters, 4.0) + 4.0, 4.0));
    constexpr std::array<math::SineCosine, 4> exact = {{{0, 1}, {1, 0}, {0, -1}, {-1, 0}}};
    return exact[static_cast<std::size_t>(turn)];
  }
  return math::sincos(degrees * std::numbers::pi / 180.0);
}

std::optional<Affine> rotation(const std::vector<double>& v) {
  const auto [sine, cosine] = of_degrees(v[0]);
  const Affine turn = {cosine, sine, -sine, cosine, 0.0, 0.0};
  if (v.size() == 1) return turn;
  return Affine{1, 0, 0, 1, v[1], v[2]}.after(turn).after({1, 0, 0, 1, -v[1], -v[2]});
}

double tangent(double degrees) {
  const auto [sine, cosine] = of_degrees(degrees);
  return sine / cosine;
}

std::optional<Affine> one_transform(std::string_view name, const std::vector<double>& v) {
  const std::size_t n = v.size();
  if (name == "matrix" && n == 6) return Affine{v[0], v[1], v[2], v[3], v[4], v[5]};
  if (name == "translate" && (n == 1 || n == 2)) return Affine{1, 0, 0, 1, v[0], n > 1 ? v[1] : 0};
  if (name == "scale" && (n == 1 || n == 2)) return Affine{v[0], 0, 0, v[n - 1], 0, 0};
  if (name == "rotate" && (n == 1 || n == 3)) return rotation(v);
  if (name == "skewX" && n == 1) return Affine{1, 0, tangent(v[0]), 1, 0, 0};
  if (name == "skewY" && n == 1) return Affine{1, tangent(v[0]), 0, 1, 0, 0};
  return std::nullopt;
}

bool is_finite(const Affine& m) {
  return std::isfinite(m.a) && std::isfinite(m.b) && std::isfinite(m.c) && std::isfinite(m.d) &&
         std::isfinite(m.e) && std::isfinite(m.f);
}

}  // namespace

void SvgNumbers::skip_separators() {
  text_ = trimmed(text_);
  if (text_.starts_with(',')) text_ = trimmed(text_.substr(1));
}

bool SvgNumbers::at_end() {
  return peek() == 0;
}

std::optional<double> SvgNumbers::number() {
  skip_separators();
  const bool has_plus = text_.starts_with('+') && !text_.starts_with("+-");
  const char* const begin = text_.data() + (has_plus ? 1 : 0);
  const char* const end = text_.data() + text_.size();
  // "inf" and "nan" are no numbers here, and "1e" of "1em" is one followed by a unit.
  const char first = begin == end ? ' ' : *begin == '-' && begin + 1 != end ? begin[1] : *begin;
  if (first != '.' && (first < '0' || first > '9')) return std::nullopt;
  double value = 0.0;
  const auto parsed = fast_float::from_chars(begin, end, value);
  if (parsed.ec != std::errc() || !std::isfinite(value)) return std::nullopt;
  text_.remove_prefix(static_cast<std::size_t>(parsed.ptr - text_.data()));
  return value;
}

std::optional<bool> SvgNumbers::flag() {
  skip_separators();
  const char c = peek();
  if (c != '0' && c != '1') return std::nullopt;
  text_.remove_prefix(1);
  return c == '1';
}

char SvgNumbers::peek() {
  text_ = trimmed(text_);
  return text_.empty() ? '\0' : text_.front();
}

char SvgNumbers::letter() {
  const char c = peek();
  if (!text_.empty()) text_.remove_prefix(1);
  return c;
}

std::optional<std::vector<double>> svg_numbers(std::string_view text) {
  SvgNumbers numbers(text);
  std::vector<double> values;
  while (!numbers.at_end()) {
    const auto value = numbers.number();
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  return values;
}

std::optional<double> svg_length(std::string_view text, double whole) {
  SvgNumbers numbers(text);
  const auto value = numbers.number();
  if (!value) return std::nullopt;
  const std::string_view unit = trimmed(numbers.rest());
  if (unit == "%") return *value / 100.0 * whole;
  constexpr std::pair<std::string_view, double> per[] = {
      {"", 1.0},    {"px", 1.0},         {"mm", 96.0 / 25.4}, {"cm", 960.0 / 25.4},
      {"in", 96.0}, {"pt", 96.0 / 72.0}, {"pc", 16.0},        {"Q", 24.0 / 25.4}};
  for (const auto& [name, units] : per) {
    if (unit == name) return *value * units;
  }
  return std::nullopt;
}

Affine Affine::after(const Affine& inner) const {
  const Vec2 origin = (*this)({inner.e, inner.f});
  return {a * inner.a + c * inner.b,
          b * inner.a + d * inner.b,
          a * inner.c + c * inner.d,
          b * inner.c + d * inner.d,
          origin.x,
          origin.y};
}

std::optional<Affine> svg_transform(std::string_view text) {
  Affine whole;
  for (text = trimmed(text); !text.empty() && text != "none";) {
    const std::size_t open = text.find('('), close = text.find(')');
    if (open == std::string_view::npos || close == std::string_view::npos || close < open)
      return std::nullopt;
    const auto values = svg_numbers(text.substr(open + 1, close - open - 1));
    if (!values) return std::nullopt;
    const auto next = one_transform(trimmed(text.substr(0, open)), *values);
    if (!next) return std::nullopt;
    whole = whole.after(*next);
    text = trimmed(text.substr(close + 1));
    if (text.starts_with(',')) text = trimmed(text.substr(1));
  }
  if (!is_finite(whole)) return std::nullopt;
  return whole;
}

std::string_view style_value(std::string_view style, std::string_view property) {
  std::string_view found;
  while (!style.empty()) {
    const std::size_t end = std::min(style.find(';'), style.size());
    const std::string_view entry = style.substr(0, end);
    style.remove_prefix(std::min(end + 1, style.size()));
    const std::size_t colon = entry.find(':');
    if (colon == std::string_view::npos || trimmed(entry.substr(0, colon)) != property) continue;
    found = trimmed(entry.substr(colon + 1));
    if (const std::size_t mark = found.find('!'); mark != std::string_view::npos)
      found = trimmed(found.substr(0, mark));  // !important
  }
  return found;
}

}  // namespace planish
