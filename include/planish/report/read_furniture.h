#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <planish/pattern/marks.h>
#include <planish/pattern/notches.h>
#include <planish/pattern/seam_notches.h>

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

/// Reads notches on both sides of seams, one a line: the number of the seam, from 1, or * for every
/// seam; the place, as 0.5 or 50% of its length or as 120mm from its first vertex; then kind and
/// double as above.
/// @throws Error as read_notches()
std::vector<SeamNotch> read_seam_notches(const std::filesystem::path& path);

/// The same from memory.
/// @param name stands for the path in errors
std::vector<Notch> parse_notches(std::string_view bytes, const std::string& name);
std::vector<Mark> parse_marks(std::string_view bytes, const std::string& name);
std::vector<SeamNotch> parse_seam_notches(std::string_view bytes, const std::string& name);

}  // namespace planish
