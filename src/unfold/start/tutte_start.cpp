#include <cmath>
#include <numbers>

#include "core/math.h"
#include "unfold/disk/inner_system.h"
#include "unfold/start/start.h"

namespace planish {

std::vector<Vec2> tutte_start(const Disk& disk, ThreadPool& pool) {
  const std::vector<SideWeights> weights(disk.triangles.size(), SideWeights{1.0, 1.0, 1.0});
  const InnerSystem laplacian(disk, weights, pool);
  std::vector<Vec2> circle;
  const double radius = 1.0 / std::sqrt(std::numbers::pi);
  for (std::size_t k = 0; k < disk.border.size(); ++k) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(disk.border.size());
    circle.push_back({radius * math::cos(angle), radius * math::sin(angle)});
  }
  return laplacian.extend(disk, circle);
}

}  // namespace planish
