#pragma once

#include <cstddef>
#include <span>

#include <planish/measure/fairness.h>

#include "core/math.h"

namespace planish {

/// Calls visit(hinge) for each inner edge once, in the order of hinges_of().
template <class Visit>
void for_each_hinge(const Connectivity& connectivity, const Visit& visit) {
  for (Index v = 0; v < connectivity.vertex_count(); ++v) {
    const auto ring = connectivity.ring(v);
    const std::size_t n = ring.size();
    // The ends of an open ring are border edges.
    const std::size_t begin = connectivity.is_border(v) ? 1 : 0;
    const std::size_t end = connectivity.is_border(v) ? n - 1 : n;
    for (std::size_t j = begin; j < end && n > 0; ++j) {
      if (ring[j] < v) continue;
      visit(Hinge{v, ring[j], ring[j + 1 < n ? j + 1 : 0], ring[j > 0 ? j - 1 : n - 1]});
    }
  }
}

/// Of the triangles a, b, left and b, a, right. The cross product of their normals lies along the
/// edge; its length is that of the edge times the normal of one over the other's third corner.
inline Bend bend_at(Vec3 a, Vec3 b, Vec3 left, Vec3 right) {
  const Vec3 edge = b - a, over = right - a;
  const Vec3 n_left = cross(edge, left - a), n_right = cross(over, edge);
  const double doubled_left = norm(n_left), doubled_right = norm(n_right);
  Bend bend;
  bend.length = norm(edge);
  bend.area = (doubled_left + doubled_right) / 6.0;
  if (doubled_left > 0.0 && doubled_right > 0.0)
    bend.angle = math::atan2(bend.length * dot(n_left, over), dot(n_left, n_right));
  return bend;
}

/// Calls visit(hinge, bend) for each inner edge of the surface times `scale`.
template <class Visit>
void for_each_bend(std::span<const Vec3> positions, const Connectivity& connectivity, double scale,
                   const Visit& visit) {
  for_each_hinge(connectivity, [&](const Hinge& hinge) {
    visit(hinge, bend_at(scale * positions[hinge.from], scale * positions[hinge.to],
                         scale * positions[hinge.left], scale * positions[hinge.right]));
  });
}

}  // namespace planish
