#pragma once

#include <array>
#include <utility>

#include <planish/mesh/tri_mesh.h>

#include "mesh/search/box_tree.h"

namespace planish {

/// The place on a triangle mesh that is nearest to a point.
struct ClosestPoint {
  Vec3 point;
  Index triangle = 0;
  /// Shares of the triangle's corners in the point, at least 0, with sum 1. Two are exactly 0 at a
  /// corner, one on a side, none inside.
  std::array<double, 3> barycentric{};
  double squared_distance = 0.0;
};

/// The point of one triangle nearest to p; its number is left 0.
ClosestPoint closest_on_triangle(const std::array<Vec3, 3>& corners, Vec3 p);

/// Finds closest points on the triangles of a mesh, which may be of any kind: open, not manifold,
/// with triangles without area or length. In the units of the mesh, whose coordinates must be
/// finite numbers with squares that neither vanish nor overflow. A tree of boxes: O(n log n) to
/// build, O(log n) for a query that is near the surface.
class ClosestPointTree {
 public:
  /// @param mesh has a triangle at least
  explicit ClosestPointTree(TriMesh mesh) : tree_(std::move(mesh)) {}

  /// The point nearest to p; of several equally near triangles that of the smallest number. Exactly
  /// what looking at all triangles one by one would find.
  ClosestPoint query(Vec3 p) const;

 private:
  BoxTree tree_;
};

}  // namespace planish
