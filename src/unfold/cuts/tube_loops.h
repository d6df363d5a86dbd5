#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// How much a border loop turns, the patch on its left: the sum of pi less the angle of the patch
/// at each vertex, radians. 2 pi of the outline of a flat piece, -2 pi of a hole in it, 0 of an end
/// of a tube.
double turning_of(const Patch& patch, std::span<const Index> loop);

/// The border loops, by their number, that are no holes: those around tubes, and the outline. A
/// loop that turns by -2 pi, or as much within pi, closes in the plane as a hole. Where all of
/// them do, the longest is the outline.
/// @pre the mesh is of one part
std::vector<std::size_t> tube_loops(const Patch& patch);

}  // namespace planish
