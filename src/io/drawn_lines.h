#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <planish/core/vec.h>

#include "io/file/text_cursor.h"

namespace planish {

/// The lines and points that an OBJ file draws.
struct LineDrawing {
  struct Line {
    std::size_t begin, end;  ///< of `corners`
    std::size_t line;        ///< of the file
  };

  std::vector<Vec3> places;
  std::vector<Index> corners;               ///< of the lines and points, one after the other
  std::vector<std::size_t> line_of_corner;  ///< of the file
  std::vector<Line> lines;
};

/// Reads the statements v, l and p of an OBJ file; others are passed over.
/// @throws Error malformed_file (also where nothing is drawn), truncated_file, bad_number,
///   non_finite_coordinate, index_out_of_range, too_large
LineDrawing parse_line_drawing(TextCursor& cursor);

/// The distance of two places, also where its square would overflow or vanish.
double distance_of(Vec3 a, Vec3 b);

/// "(1, 2.5, -3)", for messages.
std::string point_text(Vec3 p);

}  // namespace planish
