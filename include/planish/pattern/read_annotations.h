#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <planish/pattern/allowance.h>
#include <planish/pattern/marks.h>
#include <planish/pattern/notches.h>

namespace planish {

/// Reads notches, one a line: its place, its kind (slit, v or t; slit where none is given) and, for
/// two side by side, the word double. The place is a whole number for a vertex, counted from 0, or
/// with a point or a % a share of the border's length. Comments from # to the end of the line.
/// @throws Error file_not_found, file_unreadable, malformed_file, bad_number, unknown_name; the
///   place has path and line
std::vector<Notch> read_notches(const std::filesystem::path& path);

/// Reads marks, one a line: a vertex, counted from 0, and cross or drill (cross where none is
/// given).
/// @throws Error as read_notches()
std::vector<Mark> read_marks(const std::filesystem::path& path);

/// Reads inner lines, one a line: the vertices that it goes through, counted from 0, two at least.
/// @throws Error as read_notches()
std::vector<InnerLine> read_inner_lines(const std::filesystem::path& path);

/// Reads notches on both sides of seams, one a line: the number of the seam, from 1, or * for every
/// seam; the place, as 0.5 or 50% of its length or as 120mm from its first vertex; then kind and
/// double as above.
/// @throws Error as read_notches()
std::vector<SeamNotch> read_seam_notches(const std::filesystem::path& path);

/// Reads allowances of stretches of the border, one a line: the vertices from which and to which,
/// the piece on the left, and the width in millimetres, as 12.5 or 12.5mm.
/// @throws Error as read_notches(); option_out_of_range for a width below 0
std::vector<EdgeAllowance> read_edge_allowances(const std::filesystem::path& path);

/// The same from memory.
/// @param name stands for the path in errors
std::vector<Notch> parse_notches(std::string_view bytes, const std::string& name);
/// As read_marks() from memory.
std::vector<Mark> parse_marks(std::string_view bytes, const std::string& name);
/// As read_inner_lines() from memory.
std::vector<InnerLine> parse_inner_lines(std::string_view bytes, const std::string& name);
/// As read_edge_allowances() from memory.
std::vector<EdgeAllowance> parse_edge_allowances(std::string_view bytes, const std::string& name);
/// As read_seam_notches() from memory.
std::vector<SeamNotch> parse_seam_notches(std::string_view bytes, const std::string& name);

}  // namespace planish
