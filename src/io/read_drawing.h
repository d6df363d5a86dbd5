#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include <planish/mesh/carry.h>

#include "io/svg/svg_drawing.h"

namespace planish {

/// Reads the lines (l) and points (p) of an OBJ file.
/// @throws Error file_not_found, file_unreadable, malformed_file, truncated_file, bad_number,
///   non_finite_coordinate, index_out_of_range, too_large; the place has path and line
DrawnLines read_obj_lines(const std::filesystem::path& path);

/// The same from memory.
/// @param name stands for the path in errors
DrawnLines parse_obj_lines(std::string_view bytes, const std::string& name);

/// An OBJ file with them: shortest digits that read back to the same doubles.
std::string format_obj_lines(const DrawnLines& drawn);

/// Reads an SVG file as parse_svg() does.
/// @throws Error file_not_found, file_unreadable, and as parse_svg()
SvgDrawing read_svg(const std::filesystem::path& path, std::span<const std::string_view> layers);

}  // namespace planish
