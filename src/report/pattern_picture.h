#pragma once

#include <string>

#include <planish/draw/drawing.h>

namespace planish {

/// The strain map and the outline of a pattern sheet as inline SVG as wide as its place, cut to the
/// pattern, with a bar that gives the size.
struct PatternPicture {
  std::string svg;
  double bar = 0.0;  ///< length of the bar, millimetres
};

/// @param label what a screen reader says, plain text
PatternPicture pattern_picture(const Drawing& sheet, const std::string& label);

}  // namespace planish
