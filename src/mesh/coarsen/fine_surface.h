#pragma once

#include <vector>

#include <planish/mesh/tri_mesh.h>

#include "mesh/coarsen/plane_quadric.h"
#include "mesh/half_edges.h"

namespace planish {

/// What a coarse patch is measured by, at each vertex of the fine one. In units of its size, from
/// its middle.
struct FineSurface {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;           ///< of length 1, or 0 where there are no triangles
  std::vector<double> areas;           ///< a third of the triangles around
  std::vector<PlaneQuadric> quadrics;  ///< planes of the triangles, lines of the border edges
};

FineSurface fine_surface(const TriMesh& mesh, const HalfEdges& half_edges);

}  // namespace planish
