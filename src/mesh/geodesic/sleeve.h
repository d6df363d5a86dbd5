#pragma once

#include <span>
#include <vector>

#include <planish/core/context.h>
#include <planish/mesh/geodesic.h>

#include "mesh/geodesic/unfolded_mesh.h"

namespace planish {

/// The triangles that a path goes through, one after the other.
struct Sleeve {
  Index first = 0;             ///< triangle in which the path begins
  std::vector<Index> entered;  ///< half-edge of each next triangle that the path comes in by

  Index last() const { return entered.empty() ? first : entered.back() / 3; }
};

/// Adds a triangle by the half-edge that is come in by; turning back takes the last one away.
void enter(Sleeve& sleeve, const HalfEdges& half_edges, Index h);

/// Goes on around a vertex of the last triangle to another triangle there, by the way of fewer
/// triangles that crosses no border.
void turn_around(Sleeve& sleeve, const UnfoldedMesh& mesh, Index v, Index triangle);

/// The triangles of a path.
/// @pre places as UnfoldedMesh::checked() gives them
/// @throws Error option_out_of_range where two that follow each other share no triangle
Sleeve sleeve_of(const UnfoldedMesh& mesh, std::span<const SurfacePoint> path);

/// The path through the sleeve drawn tight: the shortest one in the sleeve (Lee and Preparata
/// 1984), which is then laid around the other side of each vertex that has less than pi there
/// (Xin and Wang 2007), until there is none.
/// @param from, to as UnfoldedMesh::checked() gives them
GeodesicPath drawn_tight(const UnfoldedMesh& mesh, Sleeve sleeve, const SurfacePoint& from,
                         const SurfacePoint& to, const Context& context);

}  // namespace planish
