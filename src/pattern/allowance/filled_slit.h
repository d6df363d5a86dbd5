#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/pattern/piece_outline.h>

namespace planish {

/// Edges of an outline that follow each other.
struct OutlineStretch {
  std::size_t loop = 0;
  std::size_t middle = 0;  ///< a point half way along
  double length = 0.0;     ///< millimetres
};

/// The stretches of the outline that an allowance leaves without a cut line beside them, as it
/// fills slits and darts: places that the other side of a slit faces, within 60 degrees, with no
/// cut line between, and the ends of such slits.
/// @param cut what offset_outline() made of the outline
/// @param width the widest allowance, millimetres, above 0
std::vector<OutlineStretch> filled_slits(std::span<const Polygon> outline,
                                         std::span<const Polygon> cut, double width);

}  // namespace planish
