#include "evolve/methods/local_region.h"

#include <algorithm>
#include <iterator>

#include "geometry/angle_gradient.h"

namespace planish {

namespace {

/// The inner neighbours of a ring of vertices, but for those of the ring itself and of the last
/// one.
std::vector<Index> next_ring(const std::vector<Index>& last, const std::vector<Index>& ring,
                             std::span<const std::span<const Index>> rings) {
  std::vector<Index> around, away, next;
  for (const Index v : ring) {
    std::copy_if(rings[v].begin(), rings[v].end(), std::back_inserter(around),
                 [&](Index w) { return w < rings.size(); });
  }
  std::sort(around.begin(), around.end());
  around.erase(std::unique(around.begin(), around.end()), around.end());
  std::set_difference(around.begin(), around.end(), ring.begin(), ring.end(),
                      std::back_inserter(away));
  std::set_difference(away.begin(), away.end(), last.begin(), last.end(), std::back_inserter(next));
  return next;
}

}  // namespace

std::size_t LocalRegion::slot_of(Index v) const {
  const auto at = std::lower_bound(active.begin(), active.end(), v);
  return at != active.end() && *at == v ? static_cast<std::size_t>(at - active.begin())
                                        : active.size();
}

LocalRegion region_around(Index center, int radius, std::span<const std::span<const Index>> rings,
                          const std::function<bool(Index)>& may_move) {
  LocalRegion region;
  std::vector<Index> last, ring = {center};
  for (int distance = 0; distance <= radius + 1; ++distance) {
    region.constrained.insert(region.constrained.end(), ring.begin(), ring.end());
    if (distance <= radius)
      std::copy_if(ring.begin(), ring.end(), std::back_inserter(region.active), may_move);
    std::vector<Index> next = next_ring(last, ring, rings);
    last = std::move(ring);
    ring = std::move(next);
  }
  std::sort(region.active.begin(), region.active.end());
  std::sort(region.constrained.begin(), region.constrained.end());
  return region;
}

Eigen::MatrixXd angle_rows(const LocalRegion& region, std::span<const std::span<const Index>> rings,
                           std::span<const Site> sites) {
  const auto at = [&](Index v) { return Vec3{sites[v].x, sites[v].y, sites[v].z}; };
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(region.constrained.size()),
                                               static_cast<Eigen::Index>(3 * region.active.size()));
  for (std::size_t i = 0; i < region.constrained.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    const auto add = [&](std::size_t place, Vec3 gradient) {
      if (place == region.active.size()) return;
      const auto column = static_cast<Eigen::Index>(3 * place);
      rows(row, column) += gradient.x;
      rows(row, column + 1) += gradient.y;
      rows(row, column + 2) += gradient.z;
    };
    const Index q = region.constrained[i];
    const auto ring = rings[q];
    const std::size_t own = region.slot_of(q);
    std::size_t place = region.slot_of(ring.back());
    for (std::size_t j = 0; j < ring.size(); ++j) {
      const std::size_t next = region.slot_of(ring[j]);
      const AngleGradient g =
          angle_gradient(at(q), at(ring[(j + ring.size() - 1) % ring.size()]), at(ring[j]));
      add(own, g.at_p);
      add(place, g.at_q);
      add(next, g.at_r);
      place = next;
    }
  }
  return rows;
}

}  // namespace planish
