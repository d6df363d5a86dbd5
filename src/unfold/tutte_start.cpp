#include <cmath>
#include <numbers>

#include "unfold/inner_system.h"
#include "unfold/start.h"

namespace planish {

std::vector<Vec2> tutte_start(const Disk& disk) {
  const std::vector<SideWeights> weights(disk.triangles.size(), SideWeights{1.0, 1.0, 1.0});
  const InnerSystem laplacian(disk, weights);
  const auto n = static_cast<Eigen::Index>(disk.vertex_count);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n), y = x;
  const double radius = 1.0 / std::sqrt(std::numbers::pi);
  for (std::size_t k = 0; k < disk.border.size(); ++k) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(disk.border.size());
    x[disk.border[k]] = radius * std::cos(angle);
    y[disk.border[k]] = radius * std::sin(angle);
  }
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(n);
  x = laplacian.solve(x, none);
  y = laplacian.solve(y, none);
  std::vector<Vec2> flat;
  for (Eigen::Index v = 0; v < n; ++v)
    flat.push_back({x[v], y[v]});
  return flat;
}

}  // namespace planish
