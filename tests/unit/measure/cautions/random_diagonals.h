#pragma once

#include "support/meshes.h"

namespace planish::meshes {

/// flat_grid() with each of its squares divided by the one or the other diagonal, at random.
inline TriMesh grid_with_random_diagonals(std::size_t columns, std::size_t rows) {
  TriMesh mesh = flat_grid(columns, rows);
  Random random(5);
  for (std::size_t t = 0; t + 1 < mesh.triangles.size(); t += 2) {
    const auto [a, b, c] = mesh.triangles[t];
    const Index d = mesh.triangles[t + 1][2];
    if (random.number() > 0.0) {
      mesh.triangles[t] = {a, b, d};
      mesh.triangles[t + 1] = {b, c, d};
    }
  }
  return mesh;
}

}  // namespace planish::meshes
