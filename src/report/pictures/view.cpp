#include "report/pictures/view.h"

#include <cmath>

#include <Eigen/Eigenvalues>

namespace planish {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// How much the eye moves from the mean normal towards the upper right, per unit along the normal.
constexpr double k_tilt_up = 0.35, k_tilt_right = 0.3;

struct Moments {
  Vector3d normal = Vector3d::Zero();      // sum of the triangles' normals by area
  double area = 0.0;                       // twice the patch's
  Matrix3d covariance = Matrix3d::Zero();  // of the corners, weighed by area
};

Moments moments_of(const TriMesh& mesh) {
  // Of a size where squares can neither overflow nor vanish, and near the origin.
  const double scale = unit_scale(mesh);
  const Vec3 centre =
      mesh.triangles.empty() ? Vec3{} : scale * mesh.positions[mesh.triangles.front().front()];
  Moments moments;
  Vector3d sum = Vector3d::Zero();
  for (const Triangle& triangle : mesh.triangles) {
    std::array<Vector3d, 3> corners;
    for (int i = 0; i < 3; ++i) {
      const Vec3 p = scale * mesh.positions[triangle[i]] + -centre;
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
  if (moments.area > 0.0) moments.covariance -= sum * sum.transpose() / moments.area;
  return moments;
}

// Columns by increasing extent.
Matrix3d principal_axes(const Matrix3d& covariance) {
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(covariance).eigenvectors();
}

// The way that counts as positive must not hang on the solver.
Vector3d with_largest_part_positive(const Vector3d& direction) {
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  return direction[largest] < 0.0 ? Vector3d(-direction) : direction;
}

Vec3 to_vec(const Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

}  // namespace

View view_of(const TriMesh& mesh) {
  const Moments moments = moments_of(mesh);
  Vector3d normal = with_largest_part_positive(principal_axes(moments.covariance).col(0));
  if (moments.normal.norm() > 1e-3 * moments.area) normal = moments.normal.normalized();
  const Matrix3d flat = Matrix3d::Identity() - normal * normal.transpose();
  const Vector3d longest = principal_axes(flat * moments.covariance * flat).col(2);
  Vector3d up = with_largest_part_positive(longest);
  const Vector3d towards = (normal + k_tilt_up * up + k_tilt_right * up.cross(normal)).normalized();
  up = (up - up.dot(towards) * towards).normalized();
  return {to_vec(up.cross(towards)), to_vec(up), to_vec(towards)};
}

}  // namespace planish
