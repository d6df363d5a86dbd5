#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// Triangles over the corners of a closed loop, in its direction, of the least largest bend and of
/// these with the shortest diagonals. (Barequet and Sharir, Filling gaps in the boundary of a
/// polyhedron, 1995; the bend as in Liepa, Filling holes in meshes, 2003.) Cubic time.
/// @param corners places, three or more
/// @param beside unit normals of the triangles outside of the loop, at corner i and i + 1; 0: any
/// @param may_join whether corners i < j, no neighbours, may be joined by an edge
/// @return corners of each triangle by their numbers in the loop; nothing where triangles would
///   have no area or be folded back
std::optional<std::vector<Triangle>> triangulate_loop(
    std::span<const Vec3> corners, std::span<const Vec3> beside,
    const std::function<bool(std::size_t, std::size_t)>& may_join);

}  // namespace planish
