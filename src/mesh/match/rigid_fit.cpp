#include "mesh/match/rigid_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SVD>

namespace planish {

namespace {

Vec3 mean_of(std::span<const Vec3> points) {
  Vec3 sum;
  for (const Vec3 p : points)
    sum += p;
  return 1.0 / static_cast<double>(points.size()) * sum;
}

Eigen::Vector3d as_eigen(Vec3 p) {
  return {p.x, p.y, p.z};
}

/// The sum of to * from^T about the means.
Eigen::Matrix3d covariance(std::span<const Vec3> from, std::span<const Vec3> to,
                           std::span<const Index> pair) {
  const Vec3 from_mean = mean_of(from), to_mean = mean_of(to);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t v = 0; v < pair.size(); ++v)
    sum += as_eigen(to[pair[v]] - to_mean) * as_eigen(from[v] - from_mean).transpose();
  return sum;
}

std::array<Vec3, 3> best_turn(const Eigen::Matrix3d& covariance, bool mirrored) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = svd.matrixU().determinant() * svd.matrixV().determinant();
  Eigen::Vector3d weights(1.0, 1.0, (sign < 0.0) == mirrored ? 1.0 : -1.0);
  const Eigen::Matrix3d turn = svd.matrixU() * weights.asDiagonal() * svd.matrixV().transpose();
  std::array<Vec3, 3> rows;
  for (int i = 0; i < 3; ++i)
    rows[static_cast<std::size_t>(i)] = {turn(i, 0), turn(i, 1), turn(i, 2)};
  return rows;
}

/// The turn with every number rounded to a whole one, if they are as near as that.
std::optional<std::array<Vec3, 3>> along_axes(const std::array<Vec3, 3>& rows, double tolerance) {
  std::array<Vec3, 3> whole = rows;
  for (Vec3& row : whole) {
    const Vec3 near = {std::round(row.x), std::round(row.y), std::round(row.z)};
    if (!(norm(near - row) <= tolerance)) return std::nullopt;
    row = near;
  }
  return whole;
}

/// The motion of that turn whose largest distances are equal along each axis both ways: exact where
/// every point is shifted alike.
RigidMotion with_shift(const std::array<Vec3, 3>& rows, std::span<const Vec3> from,
                       std::span<const Vec3> to, std::span<const Index> pair) {
  RigidMotion motion{rows, {}};
  if (pair.empty()) return motion;
  Vec3 low = to[pair[0]] - motion(from[0]), high = low;
  for (std::size_t v = 1; v < pair.size(); ++v) {
    const Vec3 d = to[pair[v]] - motion(from[v]);
    low = {std::min(low.x, d.x), std::min(low.y, d.y), std::min(low.z, d.z)};
    high = {std::max(high.x, d.x), std::max(high.y, d.y), std::max(high.z, d.z)};
  }
  motion.shift = 0.5 * (low + high);
  return motion;
}

}  // namespace

RigidMotion rigid_fit(std::span<const Vec3> from, std::span<const Vec3> to,
                      std::span<const Index> pair, bool mirrored, double tolerance) {
  const std::array<Vec3, 3> rows = best_turn(covariance(from, to, pair), mirrored);
  if (const auto whole = along_axes(rows, tolerance)) {
    const RigidMotion motion = with_shift(*whole, from, to, pair);
    if (brings_together(motion, from, to, pair, tolerance)) return motion;
  }
  return with_shift(rows, from, to, pair);
}

bool brings_together(const RigidMotion& motion, std::span<const Vec3> from,
                     std::span<const Vec3> to, std::span<const Index> pair, double tolerance) {
  for (std::size_t v = 0; v < pair.size(); ++v) {
    if (!(norm(to[pair[v]] - motion(from[v])) <= tolerance)) return false;
  }
  return true;
}

}  // namespace planish
