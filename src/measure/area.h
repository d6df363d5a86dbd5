#pragma once

#include <planish/mesh/tri_mesh.h>

#include "core/careful_sum.h"

namespace planish {

/// The area of a mesh whose coordinates are multiplied by `scale` first, so that none overflows.
inline double area_of(const TriMesh& mesh, double scale) {
  CarefulSum doubled;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = scale * mesh.positions[t[0]];
    doubled.add(norm(cross(scale * mesh.positions[t[1]] - a, scale * mesh.positions[t[2]] - a)));
  }
  return 0.5 * doubled.value();
}

}  // namespace planish
