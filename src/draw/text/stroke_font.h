#pragma once

#include <optional>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// Height of the font's capitals, in steps of its grid.
inline constexpr double k_font_capital = 8.0;
/// Between one glyph and the next.
inline constexpr double k_font_gap = 2.0;

/// A character as lines in steps of the grid; x from 0 to `width`, the baseline at y = 0.
struct Glyph {
  double width = 0.0;
  std::vector<std::vector<Vec2>> lines;
};

/// The glyph of a code point; nothing where the font has none.
std::optional<Glyph> stroke_glyph(char32_t code_point);

}  // namespace planish
