#pragma once

#include <string>

#include <planish/draw/drawing.h>

namespace planish {

/// The drawing as a stand-alone SVG at true size: width and height in mm, one user unit = 1 mm,
/// each layer a group that Inkscape shows as a layer; coordinates to 0.001 mm. The same drawing
/// gives the same bytes. Text is escaped; bytes that are no UTF-8 become U+FFFD. Sizes and places
/// are to be finite; points and texts that are nowhere are left out.
std::string write_svg(const Drawing& drawing);

}  // namespace planish
