#pragma once

#include <span>

#include <planish/mesh/tri_mesh.h>

#include <Eigen/Core>

namespace planish {

/// How a surface lies and spreads in space.
struct SurfaceMoments {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();      ///< sum of the triangles' normals by area
  double area = 0.0;                                     ///< twice the surface's
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();      ///< centroid of the area, scaled
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  ///< of the corners, weighed by area
};

/// @param scale that positions are multiplied by, so that no square overflows or vanishes
SurfaceMoments moments_of(std::span<const Triangle> triangles, std::span<const Vec3> positions,
                          double scale);

/// Columns by increasing extent; their signs are the solver's.
Eigen::Matrix3d principal_axes(const Eigen::Matrix3d& covariance);

}  // namespace planish
