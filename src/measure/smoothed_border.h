#pragma once

#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// The positions of all vertices when short waves are taken out of the border, along its curves
/// from corner to corner; corners and inner vertices stay. Minimises along each curve
///
///   |x - x0|^2 + t |x''|^2,  t = (wave / 2 pi)^4,
///
/// so a wave of that length is halved, one twice as long keeps 94 %. A corner turns by more than 45
/// degrees between places that are a quarter of the wave away on both sides. O(n).
/// @param wave a length in model units, above 0
std::vector<Vec3> with_smoothed_border(const Patch& patch, double wave);

}  // namespace planish
