#pragma once

#include <span>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// The Delaunay triangulation inside a polygon: no diagonal has a better one across its quad.
/// Where either does, the triangle with the lowest number gets it.
/// @param places counter-clockwise, as in_own_plane() gives them
/// @param numbers of the places, which ties are decided by
/// @param ears as clip_ears() gives them
/// @return numbers of places, counter-clockwise
std::vector<Triangle> delaunay_triangles(std::span<const Vec2> places,
                                         std::span<const Index> numbers,
                                         std::span<const Triangle> ears);

}  // namespace planish
