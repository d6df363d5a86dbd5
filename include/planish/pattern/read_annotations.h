#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <planish/io/read_features.h>
#include <planish/mesh/patch.h>
#include <planish/pattern/allowance.h>
#include <planish/pattern/marks.h>
#include <planish/pattern/notches.h>

namespace planish {

// What rows of a file, or of a caller that has them in memory, say of a pattern.

/// Notches: the place, the kind (slit, v or t; slit where none is given) and, for two side by side,
/// the word double. The place is a whole number for a vertex, counted from 0, or with a point or a
/// % a share of the border's length.
/// @throws Error malformed_file, bad_number, unknown_name; the place is that of the row
std::vector<Notch> notches_in(const Rows& rows);

/// Marks: a vertex, counted from 0, and cross or drill (cross where none is given).
/// @throws Error as notches_in()
std::vector<Mark> marks_in(const Rows& rows);

/// Inner lines: the vertices that each goes through, counted from 0, two at least.
/// @throws Error as notches_in()
std::vector<InnerLine> inner_lines_in(const Rows& rows);

/// Notches on both sides of seams: the number of the seam, from 1, or * for every seam; the place,
/// as 0.5 or 50% of its length or as 120mm from its first vertex; then kind and double as above.
/// @throws Error as notches_in()
std::vector<SeamNotch> seam_notches_in(const Rows& rows);

/// Allowances of stretches of the border: the vertices from which and to which, the piece on the
/// left, and the width in millimetres, as 12.5 or 12.5mm.
/// @throws Error as notches_in(); option_out_of_range for a width below 0
std::vector<EdgeAllowance> edge_allowances_in(const Rows& rows);

/// Notches, marks or inner lines that an OBJ file draws over a patch.
struct DrawnAnnotations {
  std::vector<Notch> notches;      ///< as read_drawn_notches() makes them; else none
  std::vector<Mark> marks;         ///< as read_drawn_marks() makes them; else none
  std::vector<SurfaceLine> lines;  ///< as read_drawn_lines() makes them; else none
  double farthest = 0.0;           ///< of the drawn points from their places; model units
  double outside_length = 0.0;  ///< of lines that lie off the patch and are left out; model units
};

/// Reads notches of an OBJ file: every point of its lines (l) and points (p) stands for the nearest
/// place of the border, and is a slit there.
/// @throws Error file_not_found, file_unreadable, malformed_file, truncated_file, bad_number,
///   non_finite_coordinate, index_out_of_range, too_large, misplaced_notch for a point that is
///   farther from the border than three mean edges; the place has path and line. Also, without a
///   place, no_triangles
DrawnAnnotations read_drawn_notches(const std::filesystem::path& path, const Patch& patch);

/// Reads marks of an OBJ file: every point of its lines and points stands for the nearest place of
/// the patch, and is a cross there.
/// @throws Error as read_drawn_notches(), with misplaced_mark
DrawnAnnotations read_drawn_marks(const std::filesystem::path& path, const Patch& patch);

/// Reads inner lines of an OBJ file: its lines where trace_lines() finds them on the patch.
/// @throws Error as read_drawn_marks(), and as trace_lines()
DrawnAnnotations read_drawn_lines(const std::filesystem::path& path, const Patch& patch);

/// As read_drawn_notches() from memory.
/// @param name stands for the path in errors
DrawnAnnotations parse_drawn_notches(std::string_view bytes, const Patch& patch,
                                     const std::string& name);
/// As read_drawn_marks() from memory.
DrawnAnnotations parse_drawn_marks(std::string_view bytes, const Patch& patch,
                                   const std::string& name);
/// As read_drawn_lines() from memory.
DrawnAnnotations parse_drawn_lines(std::string_view bytes, const Patch& patch,
                                   const std::string& name);

}  // namespace planish
