#pragma once

#include <span>
#include <string>
#include <vector>

#include <planish/draw/drawing.h>
#include <planish/sheet/pattern_geometry.h>

namespace planish {

/// A pattern of lines and notches with the rest of what its options ask for, where it lies: fold,
/// grain, marks, inner lines and texts.
/// @throws Error as grain_direction() and mark_lines()
PatternGeometry annotated(PatternGeometry pattern, const TriMesh& mesh);

/// The layers seam, notch, grain, fold, drill, internal and annotation, in that order, and behind
/// them cut, as a piece is marked before it is free; what was not asked for is empty.
std::vector<Layer> piece_layers(const PatternGeometry& pattern);

/// What the lines of a piece mean, of those layers that have any: "red: cut · green: grain".
std::string line_words(std::span<const Layer> layers);

/// The direction of the grain where the pattern lies, of length 1.
/// @throws Error as grain_direction()
Vec2 grain_on_sheet(const Grain& grain, const TriMesh& mesh, const PatternGeometry& pattern);

}  // namespace planish
