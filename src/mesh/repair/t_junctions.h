#pragma once

#include <cstddef>
#include <vector>

#include <planish/mesh/tri_mesh.h>

#include "mesh/edge_sides.h"
#include "mesh/repair/border_places.h"

namespace planish {

/// A border vertex that lies on a border edge of another triangle.
struct TJunction {
  EdgeSide side;
  double share;  ///< of the edge from its first corner in the triangle, inside 0 to 1
  Index vertex;  ///< the smallest of its place
};

/// By triangle, corner and share; on one edge no two at one share.
/// @param mesh at the scale of unit_scale()
std::vector<TJunction> find_t_junctions(const TriMesh& mesh, const std::vector<EdgeSide>& border,
                                        const BorderPlaces& places);

/// A mesh with triangles divided at T-junctions. Each junction is a new vertex behind all others,
/// in their order. Of a divided triangle the first part keeps its number, others come behind.
struct DividedTriangles {
  TriMesh mesh;
  std::vector<Index> source;         ///< of each triangle
  std::vector<Index> vertex_source;  ///< of each vertex: itself, or the junction's
};

DividedTriangles divide_at(const TriMesh& mesh, const std::vector<TJunction>& junctions);

}  // namespace planish
