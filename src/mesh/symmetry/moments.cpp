#include "mesh/symmetry/moments.h"

#include <array>

#include <Eigen/Eigenvalues>

namespace planish {

using Eigen::Matrix3d;
using Eigen::Vector3d;

SurfaceMoments moments_of(std::span<const Triangle> triangles, std::span<const Vec3> positions,
                          double scale) {
  // Near the origin, where differences keep their digits.
  const Vec3 centre = triangles.empty() ? Vec3{} : scale * positions[triangles.front().front()];
  SurfaceMoments moments;
  Vector3d sum = Vector3d::Zero();
  for (const Triangle& triangle : triangles) {
    std::array<Vector3d, 3> corners;
    for (int i = 0; i < 3; ++i) {
      const Vec3 p = scale * positions[triangle[i]] + -centre;
      corners[i] = {p.x, p.y, p.z};
    }
    const Vector3d normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double area = normal.norm();
    moments.normal += normal;
    moments.area += area;
    for (const Vector3d& corner : corners) {
      sum += area / 3.0 * corner;
      moments.covariance += area / 3.0 * corner * corner.transpose();
    }
  }
  moments.middle = {centre.x, centre.y, centre.z};
  if (moments.area > 0.0) moments.middle += sum / moments.area;
  if (moments.area > 0.0) moments.covariance -= sum * sum.transpose() / moments.area;
  return moments;
}

Matrix3d principal_axes(const Matrix3d& covariance) {
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(covariance).eigenvectors();
}

}  // namespace planish
