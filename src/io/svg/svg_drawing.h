#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// A polyline of an SVG file. Millimetres, y upwards.
struct SvgLine {
  std::vector<Vec2> points;  ///< a single one is a dot; closed lines end in their first point
  std::size_t line = 0;      ///< of the file
  std::string layer;         ///< which of the named layers it is in; empty: none of them
};

/// What an SVG file shows as lines.
struct SvgDrawing {
  std::vector<SvgLine> lines;
  /// How many visible elements of a kind were left out, as {"text", 2}.
  std::map<std::string, std::size_t> left_out;
};

/// Reads the lines of an SVG file at true size: paths, lines, polylines, polygons, rectangles,
/// circles and ellipses, with all transforms; curves become chords within 0.01 mm. What is hidden
/// (display, visibility, or neither stroke nor fill) is passed over but for named layers. A unit
/// without a size is a pixel, 1/96 in.
/// @param layers groups with one of these ids are named layers
/// @throws Error malformed_file, truncated_file, too_large; the place has path and line
SvgDrawing parse_svg(std::string_view bytes, std::string_view name,
                     std::span<const std::string_view> layers);

}  // namespace planish
