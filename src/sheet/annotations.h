#pragma once

#include <span>
#include <string>
#include <vector>

#include <planish/draw/drawing.h>
#include <planish/pattern/pattern_options.h>

#include "sheet/piece/placed_pattern.h"

namespace planish {

/// The layers seam, notch, grain, fold, drill, internal and annotation, in that order; what was not
/// asked for is empty.
/// @throws Error as grain_direction() and mark_lines()
std::vector<Layer> annotations_layers(const TriMesh& mesh, const PlacedPattern& pattern,
                                      const PatternOptions& options);

/// The annotations_layers(), and behind them the layer cut, as a piece is marked before it is free:
/// all that there is to it, wherever it lies.
std::vector<Layer> piece_layers(const TriMesh& mesh, const PlacedPattern& pattern,
                                const PatternOptions& options);

/// What the lines of a piece mean, of those layers that have any: "red: cut · green: grain".
std::string line_words(std::span<const Layer> layers);

/// The direction of the grain where the pattern lies, of length 1.
/// @throws Error as grain_direction()
Vec2 grain_on_sheet(const Grain& grain, const TriMesh& mesh, const PlacedPattern& pattern);

}  // namespace planish
