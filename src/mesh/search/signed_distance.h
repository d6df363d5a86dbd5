#pragma once

#include <array>
#include <string_view>
#include <vector>

#include <planish/mesh/tri_mesh.h>

#include "mesh/search/closest_point.h"

namespace planish {

/// The distance from a closed surface, and which way it grows.
struct Distance {
  double value = 0.0;  ///< below 0 inside
  Vec3 gradient;       ///< a unit vector
};

/// Distances from a closed manifold surface whose triangles all have an area and are oriented
/// outwards: see require_closed(). In its units, with the limits of ClosestPointTree.
///
/// The normal at the closest point says which side a point is on: of the triangle, the sum of
/// both normals on a side, and at a corner the sum of all, each weighted by its triangle's angle.
/// That is right everywhere (Baerentzen and Aanaes, Signed distance computation using the angle
/// weighted pseudonormal, 2005), where a single triangle's normal is wrong near edges and corners.
class SignedDistance {
 public:
  explicit SignedDistance(const TriMesh& surface);

  /// On the surface, where a direction would be made of rounding errors, the gradient is the
  /// normal.
  Distance at(Vec3 p) const;

 private:
  Vec3 normal_at(const ClosestPoint& closest) const;

  ClosestPointTree tree_;
  double rounding_ = 0.0;  // distances up to this have no direction
  std::vector<Triangle> triangles_;
  std::vector<Vec3> of_triangle_;             // unit normals
  std::vector<std::array<Vec3, 3>> of_side_;  // not of unit length
  std::vector<Vec3> of_vertex_;               // not of unit length
};

/// @throws Error where the surface has no inside and outside: what blocks measuring, open_surface,
///   zero_area, or inconsistent_orientation where its volume is below 0; `what` names the surface.
void require_closed(const TriMesh& surface, std::string_view what);

}  // namespace planish
