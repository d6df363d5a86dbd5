#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "mesh/half_edges.h"

namespace planish {

/// The closed loops of vertices around a part of a mesh, the part on their left; holes have loops
/// of their own. An edge between two triangles of the part is in none. Linear time.
/// @param in_part one per triangle
std::vector<std::vector<Index>> outlines(const HalfEdges& mesh,
                                         const std::function<bool(std::size_t)>& in_part);

}  // namespace planish
