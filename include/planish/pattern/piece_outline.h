#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <planish/core/unit.h>
#include <planish/core/vec.h>

namespace planish {

/// A closed line without its first point again at the end. Millimetres.
using Polygon = std::vector<Vec2>;

/// The border of a piece in the plane: the outer line first, counter-clockwise, then those of
/// holes, clockwise, so that the piece is on the left of all of them.
struct PieceOutline {
  std::string piece;           ///< what messages call it
  std::vector<Polygon> loops;  ///< millimetres
  /// The vertices of the mesh that the points of the loops are; empty where there is no mesh.
  std::vector<std::vector<Index>> vertices = {};
};

/// Places of a pattern in millimetres.
/// @param positions in the unit of its model
std::vector<Vec2> in_millimetres(std::span<const Vec2> positions, Unit unit);

/// The outline of a pattern: the loop that encloses most comes first, each begins at its vertex of
/// the smallest number.
/// @param loops of vertices, the patch on their left, as Patch::border_loops() has them
/// @param positions of all vertices, millimetres
PieceOutline piece_outline(std::vector<std::vector<Index>> loops, std::span<const Vec2> positions,
                           std::string piece);

/// A stretch of an outline from one corner to the next one.
struct OutlineEdge {
  std::size_t loop = 0;                  ///< of the outline
  std::vector<std::size_t> points = {};  ///< of the loop, from corner to corner
  double length = 0.0;                   ///< millimetres
};

/// The outline from corner to corner, loop by loop; one stretch all around where there is none. Of
/// each loop the first one begins at the first corner from the vertex of the smallest number on,
/// without vertices from the first point on. docs/pattern.md says what counts as a corner.
std::vector<OutlineEdge> edges_between_corners(const PieceOutline& outline);

/// > 0 where the loop runs counter-clockwise. Square millimetres.
double signed_area(std::span<const Vec2> loop);

}  // namespace planish
