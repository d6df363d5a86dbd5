#pragma once

#include <optional>

#include <planish/mesh/patch.h>
#include <planish/mesh/surface_line.h>

namespace planish {

/// The half of a mirrored mesh, which its first half of triangles is.
TriMesh half_of(const TriMesh& whole);

/// A half without edges inside whose ends are both on the plane: they are divided in the middle,
/// else its mirror image would have the same edge.
TriMesh without_chords(TriMesh half, const Plane& plane);

/// A product with the plane as edges, where it crosses it: seams along them lie in the plane.
Patch with_plane_as_edges(const Patch& product, const Plane& plane);

/// The half of a product on the greater side of a plane in which it is symmetric. Nothing where it
/// is in several parts.
/// @throws Error not_symmetric, as require_symmetric()
std::optional<Patch> halved_product(const Patch& product, const Plane& plane);

}  // namespace planish
