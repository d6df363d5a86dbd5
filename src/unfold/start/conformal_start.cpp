#include <numbers>

#include "core/math.h"
#include "unfold/disk/disk_angles.h"
#include "unfold/start/start.h"

namespace planish {

namespace {

/// The lengths of the border edges.
std::vector<double> border_lengths(const Disk& disk) {
  std::vector<Index> next(disk.vertex_count, 0);
  for (std::size_t k = 0; k < disk.border.size(); ++k)
    next[disk.border[k]] = disk.border_edge(k)[1];
  std::vector<double> length_from(disk.vertex_count, 0.0);
  for (std::size_t t = 0; t < disk.triangles.size(); ++t) {
    const Triangle& tri = disk.triangles[t];
    const RestTriangle& rest = disk.rest[t];
    const std::array<double, 3> sides{rest.length, norm(rest.tip - Vec2{rest.length, 0.0}),
                                      norm(rest.tip)};
    for (int k = 0; k < 3; ++k) {
      const Index a = tri[k], b = tri[(k + 1) % 3];
      if (disk.is_border(a) && next[a] == b) length_from[a] = sides[k];
    }
  }
  std::vector<double> lengths;
  for (const Index v : disk.border)
    lengths.push_back(length_from[v]);
  return lengths;
}

/// The closed polygon with these exterior angles whose sides are nearest to these lengths (least
/// squares weighted by 1 / length).
std::vector<Vec2> closed_polygon(const std::vector<double>& turns, std::vector<double> lengths) {
  std::vector<Vec2> directions;
  double heading = 0.0;
  for (std::size_t k = 0; k < turns.size(); ++k) {
    if (k > 0) heading += turns[k];
    directions.push_back({math::cos(heading), math::sin(heading)});
  }
  Vec2 gap;
  double xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t k = 0; k < turns.size(); ++k) {
    const Vec2 d = directions[k];
    gap = gap + lengths[k] * d;
    xx += lengths[k] * d.x * d.x, xy += lengths[k] * d.x * d.y, yy += lengths[k] * d.y * d.y;
  }
  const double determinant = xx * yy - xy * xy;
  const Vec2 multiplier{(yy * gap.x - xy * gap.y) / determinant,
                        (xx * gap.y - xy * gap.x) / determinant};
  std::vector<Vec2> polygon;
  Vec2 at;
  for (std::size_t k = 0; k < turns.size(); ++k) {
    polygon.push_back(at);
    at = at + (lengths[k] * (1.0 - dot(directions[k], multiplier))) * directions[k];
  }
  return polygon;
}

}  // namespace

std::vector<Vec2> conformal_start(const Disk& disk, ThreadPool& pool) {
  const DiskAngles angles = disk_angles(disk);
  const InnerSystem laplacian(disk, angles.half_cotangents, pool);
  if (laplacian.inner_count() > 0 && !laplacian.solvable()) return {};

  const Eigen::VectorXd flux = laplacian.apply(log_scale(laplacian, angles));
  std::vector<double> turns;
  for (const Index v : disk.border)
    turns.push_back(std::numbers::pi - angles.sums[v] + flux[v]);

  return laplacian.extend(disk, closed_polygon(turns, border_lengths(disk)));
}

}  // namespace planish
