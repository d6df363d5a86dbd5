#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/tri_mesh.h>

#include "mesh/coarsen/plane_quadric.h"
#include "mesh/half_edges.h"

namespace planish {

/// The vertices of a mesh in another order, in units of its size, from its middle. Computed where
/// they are asked for, as copies of large meshes take much memory.
class ScaledPositions {
 public:
  /// @param mesh must outlive it, as must `order`: the vertices of the mesh in their order here
  ScaledPositions(const TriMesh& mesh, std::span<const Index> order);

  std::size_t size() const { return order_.size(); }
  Vec3 operator[](Index v) const { return scale_ * positions_[order_[v]] - middle_; }

 private:
  std::span<const Vec3> positions_;
  std::span<const Index> order_;
  double scale_ = 1.0;
  Vec3 middle_;
};

/// What a coarse patch is measured by, at each vertex of the fine one, in the units of its
/// positions.
struct FineSurface {
  ScaledPositions positions;
  std::vector<Vec3> normals;  ///< of length 1, or 0 where there are no triangles
  std::vector<double> areas;  ///< a third of the triangles around
};

/// @param half_edges of all triangles, in the numbers of the positions
FineSurface fine_surface(const ScaledPositions& positions, const HalfEdges& half_edges);

/// By vertex, of the planes of its triangles and the lines of its border edges.
std::vector<PlaneQuadric> fine_quadrics(const ScaledPositions& positions,
                                        const HalfEdges& half_edges);

}  // namespace planish
