#pragma once

#include <cstddef>
#include <string>

#include <planish/draw/drawing.h>

namespace planish {

/// A sheet of nest_sheet() with its pieces as inline SVG as wide as its place: border, lines and
/// the names of the pieces; without the words beside the sheet. Class "sheet".
/// @param number of the sheet on its page, from 1
/// @param label what a screen reader says, plain text
std::string sheet_picture(const Drawing& sheet, std::size_t number, const std::string& label);

}  // namespace planish
