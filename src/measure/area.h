#pragma once

#include <cstddef>

#include <planish/mesh/tri_mesh.h>

#include "core/neumaier_sum.h"

namespace planish {

/// The area of a mesh whose coordinates are multiplied by `scale` first, so that none overflows.
inline double area_of(const TriMesh& mesh, double scale) {
  NeumaierSum doubled;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = scale * mesh.positions[t[0]];
    doubled.add(norm(cross(scale * mesh.positions[t[1]] - a, scale * mesh.positions[t[2]] - a)));
  }
  return 0.5 * doubled.value();
}

/// The mean length of the sides of all triangles, likewise; 0 where there is none.
inline double mean_side_of(const TriMesh& mesh, double scale) {
  NeumaierSum sum;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k)
      sum.add(norm(scale * mesh.positions[t[(k + 1) % 3]] - scale * mesh.positions[t[k]]));
  }
  return mesh.triangles.empty() ? 0.0
                                : sum.value() / (3.0 * static_cast<double>(mesh.triangles.size()));
}

}  // namespace planish
