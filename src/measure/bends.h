#pragma once

#include <span>

#include <planish/measure/fairness.h>

#include "core/math.h"
#include "mesh/edges.h"

namespace planish {

/// Calls visit(hinge) for each inner edge once, in the order of hinges_of().
template <class Visit>
void for_each_hinge(const Connectivity& connectivity, const Visit& visit) {
  for_each_edge(connectivity, [&](const Edge& edge) {
    if (!edge.is_border()) visit(Hinge{edge.from, edge.to, edge.left, edge.right});
  });
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
