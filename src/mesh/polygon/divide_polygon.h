#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// Divides a face of four corners by the diagonal that lies inside it; where both do, by the
/// better_diagonal() in the plane of its area vector, where either is by that at the lowest vertex.
/// So the result does not depend on the corner that the face begins with, nor on its direction, and
/// mirrored halves are divided alike.
/// @param corners vertices, all different
/// @return two triangles that turn as the face does; nothing where it crosses itself. A face all on
///   one line is divided in any way.
std::optional<std::array<Triangle, 2>> divide_quad(const std::array<Index, 4>& corners,
                                                   std::span<const Vec3> positions);

/// Divides a face of any number of corners likewise: the Delaunay triangulation inside it, in the
/// plane of its area vector. Time about n log n. Holes are kept where a bridge, a line that the
/// face follows forth and back, leads to each of them.
/// @param corners vertices, at least 4, none twice in a row
/// @return two fewer than corners; nothing where the face crosses itself, or has a vertex twice
///   without a bridge
std::optional<std::vector<Triangle>> divide_polygon(std::span<const Index> corners,
                                                    std::span<const Vec3> positions);

}  // namespace planish
