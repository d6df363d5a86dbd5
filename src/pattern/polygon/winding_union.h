#pragma once

#include <span>
#include <vector>

#include <planish/pattern/piece_outline.h>

namespace planish {

/// The border of where closed lines wind around counter-clockwise at least once, as lines that meet
/// neither themselves nor each other: outer ones, counter-clockwise, then those of holes,
/// clockwise. Done on a grid of 0.00001 mm, which places are rounded to.
/// @throws Error too_large for coordinates of 10^10 mm and more, or that are no numbers
std::vector<Polygon> winding_union(std::span<const Polygon> lines);

}  // namespace planish
