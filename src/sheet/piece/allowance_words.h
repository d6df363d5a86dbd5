#pragma once

#include <string>

#include <planish/pattern/pattern_options.h>

namespace planish {

/// The widths of an allowance: "10 mm allowance", or where stretches have others "allowance 10 mm,
/// 30 mm at edge 2"; empty without. Edges go from corner to corner and are counted from 1, from the
/// outline's first point on; a part of one is named so.
/// @param outline with vertices, without the fold where there is one
std::string allowance_words(const PieceOutline& outline, const PatternOptions& options);

}  // namespace planish
