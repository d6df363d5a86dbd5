#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// A line of a chart.
struct ChartLine {
  std::string name;          ///< at its end, markup
  std::string css_class;     ///< sets --line, its colour; polyline.CLASS may set its dashes
  std::vector<Vec2> points;  ///< x from 0 on and never less than before, y above 0; one at least
  bool has_dots = false;     ///< at every point, not at the end only
  std::vector<Vec2> aside = {};  ///< dots that the line does not go through
  /// Beside the points, one for each of the first, markup; left out where there is no room.
  std::vector<std::string> point_names = {};
};

enum class ChartScale {
  linear,
  whole,        ///< the same with whole numbers only below it
  logarithmic,  ///< behind a stub for what is at 0
};

/// Lines over an axis that begins at 0, and beside a logarithmic axis: inline SVG as wide as its
/// place. Each line has its name at the right, where a thin line leads to it from its end; names
/// are pushed apart where they would touch. What cannot be seen for width is left out.
/// @param lines one at least, and with a point beyond x = 0
/// @param x_name below the axis, markup
/// @param label what a screen reader says, markup
std::string log_chart(const std::vector<ChartLine>& lines, ChartScale x_scale,
                      std::string_view x_name, std::string_view label);

}  // namespace planish
