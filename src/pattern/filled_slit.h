#pragma once

#include <span>

#include <planish/pattern/piece_outline.h>

namespace planish {

/// The length of the outline's edges that an allowance leaves without a cut line beside them, as it
/// fills slits and darts: those with both ends farther from the cut line than two widths. No edge
/// of a bay with an angle of 60 degrees or more is as far. Millimetres.
/// @param cut what offset_outline() made of the outline
/// @param width the widest allowance, millimetres, above 0
double filled_slit_length(std::span<const Polygon> outline, std::span<const Polygon> cut,
                          double width);

}  // namespace planish
