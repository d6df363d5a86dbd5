#include "unfold/cuts/dart_tips.h"

#include <algorithm>
#include <cmath>

#include "unfold/disk/disk_angles.h"

namespace planish {

namespace {

constexpr double k_weakest = 0.2;    ///< over the strongest
constexpr double k_least_gap = 0.1;  ///< between tips, over the bounding box's diagonal
constexpr double k_no_scale = 1e-9;  ///< below, the scale is 1 but for rounding

/// By vertex of the mesh; 0 at the border.
std::vector<double> log_scales(const Patch& patch) {
  std::vector<double> scales(patch.vertex_count(), 0.0);
  const Disk disk = make_disk(patch);
  const DiskAngles angles = disk_angles(disk);
  ThreadPool alone(1);
  const InnerSystem laplacian(disk, angles.half_cotangents, alone);
  if (laplacian.inner_count() == 0 || !laplacian.solvable()) return scales;
  const Eigen::VectorXd scale = log_scale(laplacian, angles);
  for (std::size_t v = 0; v < disk.vertex_count; ++v) {
    if (disk.is_border(static_cast<Index>(v))) continue;
    scales[disk.vertex_of[v]] = scale[static_cast<Eigen::Index>(v)];
  }
  return scales;
}

}  // namespace

std::vector<DartTip> dart_tips(const Patch& patch, std::size_t most) {
  const std::vector<double> scales = log_scales(patch);
  std::vector<double> strong = scales;
  for (double& strength : strong)
    strength = std::abs(strength);
  std::vector<Index> peaks;
  for (const Index v : patch.inner_vertices()) {
    const auto ring = patch.ring(v);
    const auto lower = [&](Index w) {
      return strong[w] < strong[v] || (strong[w] == strong[v] && v < w);
    };
    if (strong[v] > k_no_scale && std::all_of(ring.begin(), ring.end(), lower)) peaks.push_back(v);
  }
  std::stable_sort(peaks.begin(), peaks.end(),
                   [&](Index v, Index w) { return strong[v] > strong[w]; });
  const double gap = k_least_gap * bounding_box_diagonal(patch.mesh());
  std::vector<DartTip> tips;
  for (const Index v : peaks) {
    if (tips.size() == most || strong[v] < k_weakest * strong[peaks.front()]) break;
    const auto is_near = [&](const DartTip& tip) {
      return norm(patch.positions()[v] - patch.positions()[tip.vertex]) < gap;
    };
    if (std::none_of(tips.begin(), tips.end(), is_near)) tips.push_back({v, scales[v]});
  }
  return tips;
}

}  // namespace planish
