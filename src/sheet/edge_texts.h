#pragma once

#include <string>
#include <vector>

#include <planish/draw/drawing.h>
#include <planish/pattern/pattern_options.h>
#include <planish/pattern/piece_outline.h>

namespace planish {

/// The width of a text over the height of its capitals, on the safe side.
double text_width(const std::string& text);

/// How much larger letters of a piece are than usual: 1 where it is 100 to 1,500 mm across, more
/// for larger pieces (9 m: 6), less for smaller ones (40 mm and less: 0.4).
/// @param outline millimetres
double letter_scale(const Polygon& outline);

/// The texts inside a piece beside its edges: their lengths where these are asked for, and the
/// numbers, partners and ends of seams.
std::vector<Text> edge_texts(const PieceOutline& outline, const PatternOptions& options);

}  // namespace planish
