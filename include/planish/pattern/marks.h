#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <planish/mesh/carry.h>
#include <planish/mesh/tri_mesh.h>
#include <planish/pattern/piece_outline.h>

namespace planish {

/// What is drawn at a mark.
enum class MarkKind {
  cross,  ///< a match mark
  drill,  ///< a hole
};
/// "cross" or "drill".
std::string_view to_string(MarkKind kind);

/// A place that is carried over from a vertex of the patch.
struct Mark {
  Index vertex = 0;                        ///< of the patch
  MarkKind kind = MarkKind::cross;         ///< what is drawn there
  std::optional<SurfacePoint> place = {};  ///< where it is, if not at the vertex
};

/// Where a mark is in the pattern.
/// @param positions of all vertices, in the unit of the result
/// @pre its vertices are among them
Vec2 place_of(const Mark& mark, std::span<const Vec2> positions);

/// A line inside a piece, as the leg of a dart or a line to be stitched, by the vertices of the
/// patch that it goes through.
using InnerLine = std::vector<Index>;

/// The size of marks from side to side, millimetres.
inline constexpr double k_cross_size = 6.0, k_drill_size = 3.0;

/// @throws Error index_out_of_range naming the piece
void check_marks(std::size_t vertex_count, std::span<const Mark> marks, std::string_view piece);

/// @throws Error index_out_of_range naming the piece
void check_inner_lines(std::size_t vertex_count, std::span<const InnerLine> lines,
                       std::string_view piece);

/// @throws Error index_out_of_range naming the piece
void check_inner_lines(std::size_t vertex_count, std::span<const SurfaceLine> lines,
                       std::string_view piece);

/// Inner lines in the pattern, straight from place to place.
/// @param positions of all vertices on the sheet, millimetres
/// @throws Error index_out_of_range naming the piece
std::vector<Polygon> inner_lines(std::span<const Vec2> positions,
                                 std::span<const SurfaceLine> lines, std::string_view piece);

/// Inner lines in the pattern, straight from vertex to vertex.
/// @param positions of all vertices on the sheet, millimetres
/// @throws Error index_out_of_range naming the piece
std::vector<Polygon> inner_lines(std::span<const Vec2> positions, std::span<const InnerLine> lines,
                                 std::string_view piece);

/// Two strokes of a cross, or a ring of 24 corners that is closed by its first point at the end.
/// @param positions of all vertices on the sheet, millimetres
/// @throws Error index_out_of_range naming the piece
std::vector<Polygon> mark_lines(std::span<const Vec2> positions, std::span<const Mark> marks,
                                std::string_view piece);

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
