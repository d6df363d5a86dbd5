#include "unfold/disk/disk_angles.h"

#include <numbers>

#include "core/math.h"

namespace planish {

DiskAngles disk_angles(const Disk& disk) {
  DiskAngles angles{{}, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(disk.vertex_count))};
  angles.half_cotangents.reserve(disk.triangles.size());
  for (std::size_t t = 0; t < disk.triangles.size(); ++t) {
    const RestTriangle& rest = disk.rest[t];
    const std::array<Vec2, 3> p{Vec2{0.0, 0.0}, Vec2{rest.length, 0.0}, rest.tip};
    SideWeights& weights = angles.half_cotangents.emplace_back();
    for (int k = 0; k < 3; ++k) {
      const Vec2 a = p[(k + 1) % 3] - p[k], b = p[(k + 2) % 3] - p[k];
      weights[k] = 0.5 * dot(a, b) / cross(a, b);
      angles.sums[disk.triangles[t][k]] += math::atan2(cross(a, b), dot(a, b));
    }
  }
  return angles;
}

Eigen::VectorXd log_scale(const InnerSystem& laplacian, const DiskAngles& angles) {
  const Eigen::Index n = angles.sums.size();
  const Eigen::VectorXd minus_defects =
      angles.sums - Eigen::VectorXd::Constant(n, 2.0 * std::numbers::pi);
  return laplacian.solve(Eigen::VectorXd::Zero(n), minus_defects);
}

}  // namespace planish
