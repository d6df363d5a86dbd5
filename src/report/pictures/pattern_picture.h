#pragma once

#include <string>

#include <planish/draw/drawing.h>

namespace planish {

/// The strain map and the lines of a pattern sheet as inline SVG as wide as its place, cut to the
/// pattern, with a bar that gives the size. Its coordinates are millimetres of the sheet, y down
/// from the upper edge.
struct PatternPicture {
  std::string svg;
  double bar = 0.0;  ///< length of the bar, millimetres
};

/// @param directions a layer drawn over the strain map
/// @param label what a screen reader says, plain text
PatternPicture pattern_picture(const Drawing& sheet, const Layer& directions,
                               const std::string& label);

}  // namespace planish
