#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/coarsen/fine_surface.h"
#include "mesh/half_edges.h"

namespace planish {

/// By vertex, the edge length of equal triangles over the surface with about this number of
/// vertices, in the units of the surface.
std::vector<double> even_sizes(const FineSurface& surface, std::size_t vertices);

/// By vertex, the edge length of triangles that have the size of the edges between fixed vertices
/// near these, and that grow with the distance from them: as fast as it takes to come down to so
/// many vertices, but not so fast that they become needles. Even where no edge is fixed.
/// @param fixed by vertex, 1 for those that stay
std::vector<double> graded_sizes(const FineSurface& surface, const HalfEdges& half_edges,
                                 std::span<const unsigned char> fixed, std::size_t vertices);

}  // namespace planish
