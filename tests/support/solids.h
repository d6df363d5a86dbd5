#pragma once

// Closed surfaces for tests, oriented outwards.

#include <cmath>
#include <numbers>

#include <planish/mesh/tri_mesh.h>

namespace planish::solids {

/// From -1 to 1 in all directions.
inline TriMesh cube() {
  TriMesh mesh;
  for (int v = 0; v < 8; ++v)
    mesh.positions.push_back({v % 2 * 2.0 - 1.0, v / 2 % 2 * 2.0 - 1.0, v / 4 * 2.0 - 1.0});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

/// A prism over a star of five points, z from -0.5 to 0.5: convex and concave edges.
inline TriMesh star_prism() {
  constexpr Index n = 10;
  TriMesh mesh;
  for (const double z : {-0.5, 0.5}) {
    for (Index i = 0; i < n; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / n, r = i % 2 == 0 ? 1.0 : 0.4;
      mesh.positions.push_back({r * std::cos(angle), r * std::sin(angle), z});
    }
    mesh.positions.push_back({0.0, 0.0, z});
  }
  constexpr Index top = n + 1;  // the first vertex up there
  for (Index i = 0; i < n; ++i) {
    const Index j = (i + 1) % n;
    mesh.triangles.push_back({n, j, i});
    mesh.triangles.push_back({top + n, top + i, top + j});
    mesh.triangles.push_back({i, j, top + j});
    mesh.triangles.push_back({i, top + j, top + i});
  }
  return mesh;
}

/// Around 0, of n rows of 2 n quadrangles between two poles; its vertices are on the sphere.
inline TriMesh sphere(double radius, Index n) {
  TriMesh mesh;
  const Index around = 2 * n;
  mesh.positions.push_back({0, 0, -radius});
  for (Index j = 1; j < n; ++j) {
    for (Index i = 0; i < around; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / around;
      const double up = std::numbers::pi * (static_cast<double>(j) / n - 0.5);
      mesh.positions.push_back({radius * std::cos(up) * std::cos(turn),
                                radius * std::cos(up) * std::sin(turn), radius * std::sin(up)});
    }
  }
  mesh.positions.push_back({0, 0, radius});
  const auto last = static_cast<Index>(mesh.positions.size() - 1);
  const auto at = [&](Index i, Index j) { return 1 + (j - 1) * around + i % around; };
  for (Index i = 0; i < around; ++i) {
    mesh.triangles.push_back({0, at(i + 1, 1), at(i, 1)});
    mesh.triangles.push_back({last, at(i, n - 1), at(i + 1, n - 1)});
    for (Index j = 1; j + 1 < n; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

}  // namespace planish::solids
