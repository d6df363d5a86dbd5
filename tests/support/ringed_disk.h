#pragma once

#include <cmath>
#include <numbers>

#include <planish/mesh/tri_mesh.h>

namespace planish::meshes {

/// Vertex 0 in the middle and rings of `around` vertices about it, 1 apart, over the plane.
/// @param height of radius and angle
template <class Height>
TriMesh ringed_disk(std::size_t around, std::size_t rings, Height height) {
  TriMesh mesh;
  mesh.positions.push_back({0.0, 0.0, height(0.0, 0.0)});
  for (std::size_t j = 1; j <= rings; ++j) {
    for (std::size_t i = 0; i < around; ++i) {
      const double angle =
          2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(around);
      const auto r = static_cast<double>(j);
      mesh.positions.push_back({r * std::cos(angle), r * std::sin(angle), height(r, angle)});
    }
  }
  const auto at = [around](std::size_t i, std::size_t j) {
    return static_cast<Index>(1 + (j - 1) * around + i % around);
  };
  for (std::size_t i = 0; i < around; ++i) {
    mesh.triangles.push_back({0, at(i, 1), at(i + 1, 1)});
    for (std::size_t j = 1; j < rings; ++j) {
      mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  }
  return mesh;
}

}  // namespace planish::meshes
