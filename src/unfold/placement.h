#pragma once

#include <span>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// The points turned (not mirrored) so that the bounding box of `outline` is smallest in area, its
/// longer side along x and its lower left corner at the origin.
std::vector<Vec2> place_in_smallest_box(std::vector<Vec2> points, std::span<const Vec2> outline);

}  // namespace planish
