#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

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
  Index vertex = 0;                 ///< of the patch
  MarkKind kind = MarkKind::cross;  ///< what is drawn there
};

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

}  // namespace planish
