#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <planish/core/vec.h>
#include <planish/draw/drawing.h>

namespace planish {

/// The text in characters that the font of text_strokes() has: the printable ones of ASCII, the
/// letters of Latin-1 and nearly all of Latin Extended-A, and common signs such as degree,
/// multiplication, dashes, ellipsis, minus and euro. All others are spelled as ascii_text() does.
std::string in_stroke_letters(std::string_view text);

/// The lines that a pen follows to write a text, in_stroke_letters(), in a font of single strokes.
/// Control characters become blanks.
std::vector<std::vector<Vec2>> text_strokes(const Text& text);

/// How long such a text is, from the left end of its first letter to the right end of its last.
/// @param height of capital letters; the result is in the same unit
double text_strokes_width(std::string_view text, double height);

/// The drawing with every text turned into a path that looks the same, for machines and readers
/// that have no letters.
Drawing with_stroked_text(Drawing drawing);

}  // namespace planish
