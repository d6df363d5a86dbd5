#include "draw/text/stroke_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "draw/text/ascii_text.h"
#include "draw/text/stroke_font.h"
#include "draw/text/utf8.h"

namespace planish {

namespace {

// The line's width over the height of capitals.
constexpr double k_weight = 1.0 / 12.0;

Path stroked(const Text& text) {
  return {.lines = text_strokes(text),
          .stroke = Stroke{text.color, k_weight * text.height},
          .piece = text.piece};
}

}  // namespace

std::string in_stroke_letters(std::string_view text) {
  std::string letters;
  while (!text.empty()) {
    const CodePoint point = decode_utf8(text);
    const std::size_t bytes = std::max(point.bytes, std::size_t{1});
    const bool is_known = point.bytes > 0 && stroke_glyph(point.value);
    letters += is_known ? std::string(text.substr(0, bytes))
                        : ascii_letters(point.bytes > 0 ? point.value : k_replacement_character);
    text.remove_prefix(bytes);
  }
  return letters;
}

double text_strokes_width(std::string_view text, double height) {
  double width = 0.0;
  for (const char32_t point : code_points(in_stroke_letters(text)))
    width += (width > 0.0 ? k_font_gap : 0.0) + stroke_glyph(point)->width;
  return width * height / k_font_capital;
}

std::vector<std::vector<Vec2>> text_strokes(const Text& text) {
  const double scale = text.height / k_font_capital;
  Vec2 pen = text.at;
  if (text.centred) pen.x -= 0.5 * text_strokes_width(text.text, text.height);
  std::vector<std::vector<Vec2>> lines;
  for (const char32_t point : code_points(in_stroke_letters(text.text))) {
    Glyph glyph = *stroke_glyph(point);
    for (std::vector<Vec2>& line : glyph.lines) {
      for (Vec2& place : line)
        place = pen + scale * place;
      lines.push_back(std::move(line));
    }
    pen.x += scale * (glyph.width + k_font_gap);
  }
  return lines;
}

Drawing with_stroked_text(Drawing drawing) {
  for (Layer& layer : drawing.layers) {
    for (DrawingShape& shape : layer.shapes) {
      if (const auto* text = std::get_if<Text>(&shape)) shape = stroked(*text);
    }
  }
  return drawing;
}

}  // namespace planish
