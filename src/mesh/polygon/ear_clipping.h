#pragma once

#include <optional>
#include <span>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// Cuts a polygon into triangles, ear by ear: corners whose two neighbours see each other. Those
/// with the shortest cut come first, so that what is left is like the polygon with fewer corners.
/// @param places as in_own_plane() gives them, counter-clockwise, without sides that cross; two
///   sides may lie on each other, as those of a bridge to a hole do
/// @return numbers of places, counter-clockwise, two fewer than places: the ears in the order in
///   which they are cut, the corner that is cut off in the middle, and what is left of the polygon;
///   nothing where no ear is left: then the polygon crosses itself at its corners
std::optional<std::vector<Triangle>> clip_ears(std::span<const Vec2> places);

}  // namespace planish
