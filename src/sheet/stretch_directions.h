#pragma once

#include <span>
#include <vector>

#include <planish/draw/drawing.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// What a pattern does to lengths around a place.
struct StretchDirection {
  Vec2 at;              ///< in the pattern
  Vec2 along;           ///< of length one: where lengths change most
  double strain = 0.0;  ///< along it; > 0 longer in the pattern, < 0 shorter
};

/// Over a grid of about `count` cells on the pattern, the strain of largest size and its direction:
/// of the mean of F F^T by area, F the map from the patch to the pattern, over the triangles whose
/// middle is in the cell. Cells that the pattern covers by less than a third are left out.
/// @param pattern one position per vertex of the mesh, in any unit
/// @param count at least 1
std::vector<StretchDirection> stretch_directions(const TriMesh& mesh, std::span<const Vec2> pattern,
                                                 int count);

/// The layer "directions": a line at every place along its direction, as long as the strain is
/// large, with heads outwards where the pattern is longer than the patch and inwards where it is
/// shorter. What is below a twentieth of the limit is left out.
/// @param places in millimetres on the sheet
/// @param limit |strain| of the longest lines
/// @param length of the longest lines, millimetres
Layer direction_layer(std::span<const StretchDirection> places, double limit, double length);

}  // namespace planish
