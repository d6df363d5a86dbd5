#pragma once

#include <vector>

#include <planish/mesh/tri_mesh.h>

#include "mesh/edge_sides.h"

namespace planish {

/// The vertex of the smallest number at the exact place of each vertex.
std::vector<Index> first_at_place(const std::vector<Vec3>& positions);

/// The sides of edges that have one triangle, by edge.
std::vector<EdgeSide> border_sides(const TriMesh& mesh);

/// Vertices on the border that are at one place, or near enough to be.
struct BorderPlaces {
  std::vector<Index> of_vertex;  ///< the smallest vertex at its place; itself if inside
  std::vector<double> reach;  ///< of each vertex on the border: what is nearer may be joined to it
};

/// Puts border vertices together: those at equal places, then the nearest ones first while no
/// vertex of a place is farther from its smallest one than its reach. That is the length or a third
/// of the shortest border edge at the vertex, if that is less.
/// @param mesh at the scale of unit_scale()
/// @param border the sides whose vertices are put together; may be all sides of the mesh
BorderPlaces find_border_places(const TriMesh& mesh, const std::vector<EdgeSide>& border,
                                double length);

}  // namespace planish
