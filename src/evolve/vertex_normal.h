#pragma once

#include "evolve/angle_jacobian.h"
#include "evolve/patch_state.h"

namespace planish {

/// The unit normal of an inner vertex, its triangles weighing as their areas; zero where they
/// cancel.
inline Vec3 vertex_normal(Index v, const AngleJacobian& jacobian, const PatchState& state) {
  const auto ring = jacobian.ring(v);
  const Vec3 p = state.position(v);
  Vec3 normal;
  for (std::size_t j = 0; j < ring.size(); ++j) {
    const Index next = ring[j + 1 < ring.size() ? j + 1 : 0];
    normal += cross(state.position(ring[j]) - p, state.position(next) - p);
  }
  const double length = norm(normal);
  return length > 0.0 ? (1.0 / length) * normal : Vec3{};
}

}  // namespace planish
