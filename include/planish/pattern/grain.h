#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <planish/mesh/tri_mesh.h>
#include <planish/pattern/piece_outline.h>

namespace planish {

/// Where a direction on the model points to in the pattern: in each triangle its part along the
/// surface is carried over with the triangle, and the mean is taken by area. Length 1.
/// @param positions of the pattern, one per vertex of the mesh
/// @throws Error no_grain_direction where that is nowhere: shorter than 0.01 of the direction
Vec2 grain_direction(const TriMesh& mesh, std::span<const Vec2> positions, Vec3 direction,
                     std::string_view piece);

/// A box that lines keep clear of.
struct ClearBox {
  Vec2 low, high;  ///< corner with the least or largest x and y, millimetres
};

/// A line with an arrow head at each end in the direction of the grain, inside the piece and clear
/// of the box: three open lines, none where not even a line of 1 mm fits. It takes the longest
/// place among 41 lines over the piece, but for a tenth at each end, and at most 200 mm of it.
/// @param direction of length 1
std::vector<Polygon> grain_lines(const PieceOutline& outline, Vec2 direction,
                                 const std::optional<ClearBox>& keep_clear = {});

}  // namespace planish
