#pragma once

#include <vector>

#include <planish/draw/drawing.h>

namespace planish {

/// A path with its closed lines from the one that encloses least to the one that encloses most:
/// holes come before the outline around them, which would free the piece.
Path inner_first(Path path);

/// The shapes of a drawing as a machine is to draw and cut them: piece by piece, by their numbers,
/// and of each piece in the order of the layers, inner lines first. Each is a layer of the drawing
/// with the shapes of one piece; those that are empty are left out.
std::vector<Layer> in_cutting_order(const Drawing& drawing);

}  // namespace planish
