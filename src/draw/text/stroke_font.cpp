#include "draw/text/stroke_font.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include "draw/text/stroke_glyphs.h"
#include "draw/text/utf8.h"

namespace planish {

namespace {

constexpr double k_x_height = 5.0;

Glyph parsed(std::string_view points) {
  Glyph glyph;
  glyph.lines.emplace_back();
  for (std::size_t i = 0; i < points.size();) {
    if (points[i] == ' ') {
      glyph.lines.emplace_back();
      ++i;
      continue;
    }
    const Vec2 point = {static_cast<double>(points[i] - '0'),
                        static_cast<double>(points[i + 1] - 'd')};
    glyph.lines.back().push_back(point);
    glyph.width = std::max(glyph.width, point.x);
    i += 2;
  }
  return glyph;
}

// The letter that `marked` is with the accent, 0 where it is none.
char32_t letter_under(const Accent& accent, char32_t marked) {
  const std::u32string pairs = code_points(accent.pairs);
  for (std::size_t i = 0; i < pairs.size(); i += 2) {
    if (pairs[i + 1] == marked) return pairs[i];
  }
  return 0;
}

double top_of(const Glyph& glyph) {
  double top = 0.0;
  for (const auto& line : glyph.lines) {
    for (const Vec2 point : line)
      top = std::max(top, point.y);
  }
  return top;
}

Glyph with_accent(Glyph letter, std::string_view points, double raised) {
  const Glyph accent = parsed(points);
  const Vec2 shift = {0.5 * letter.width - 2.0, raised};
  for (std::vector<Vec2> line : accent.lines) {
    for (Vec2& point : line)
      point = point + shift;
    letter.lines.push_back(std::move(line));
  }
  return letter;
}

// Accents may be wider than what they stand over.
Glyph from_zero(Glyph glyph) {
  double low = 0.0, high = glyph.width;
  for (const auto& line : glyph.lines) {
    for (const Vec2 point : line) {
      low = std::min(low, point.x);
      high = std::max(high, point.x);
    }
  }
  for (auto& line : glyph.lines) {
    for (Vec2& point : line)
      point.x -= low;
  }
  glyph.width = high - low;
  return glyph;
}

std::optional<Glyph> composed(char32_t code_point) {
  for (const Accent& accent : k_accents) {
    const char32_t base = letter_under(accent, code_point);
    if (base == 0) continue;
    Glyph letter = *stroke_glyph(base);
    if (base == U'i' || base == U'j') letter.lines.resize(1);  // the accent takes the dot's place
    const double raised = top_of(letter) - k_x_height;
    return from_zero(with_accent(std::move(letter), accent.points, raised));
  }
  for (const Accent& accent : k_accents_below) {
    const char32_t base = letter_under(accent, code_point);
    if (base != 0) return from_zero(with_accent(*stroke_glyph(base), accent.points, 0.0));
  }
  return std::nullopt;
}

bool is_blank(char32_t code_point) {
  return code_point <= U' ' || (code_point >= 0x7F && code_point <= 0xA0) ||
         (code_point >= 0x2000 && code_point <= 0x200B) || code_point == 0x202F;
}

}  // namespace

std::optional<Glyph> stroke_glyph(char32_t code_point) {
  if (is_blank(code_point)) return Glyph{2.0, {}};
  if (code_point <= U'~') return parsed(k_ascii[code_point - U'!']);
  const auto* const other =
      std::lower_bound(std::begin(k_others), std::end(k_others), code_point,
                       [](const DrawnGlyph& glyph, char32_t c) { return glyph.code_point < c; });
  if (other != std::end(k_others) && other->code_point == code_point) {
    return parsed(other->points);
  }
  return composed(code_point);
}

}  // namespace planish
