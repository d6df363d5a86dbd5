#pragma once

// Meshes that are others again, elsewhere and with other numbers.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <planish/mesh/tri_mesh.h>

#include "support/meshes.h"

namespace planish::meshes {

/// x with the other sign, triangles turned so that the outer side stays outside.
inline TriMesh mirrored(TriMesh mesh) {
  for (Vec3& p : mesh.positions)
    p.x = -p.x;
  for (Triangle& t : mesh.triangles)
    std::swap(t[1], t[2]);
  return mesh;
}

/// Turned about two axes and shifted.
inline TriMesh turned(TriMesh mesh) {
  const double c = std::cos(0.7), s = std::sin(0.7), d = std::cos(1.1), r = std::sin(1.1);
  for (Vec3& p : mesh.positions) {
    p = {c * p.x - s * p.y, s * p.x + c * p.y, p.z};
    p = Vec3{p.x, d * p.y - r * p.z, r * p.y + d * p.z} + Vec3{3.0, -2.0, 1.0};
  }
  return mesh;
}

/// Every coordinate as a 32-bit float.
inline TriMesh in_floats(TriMesh mesh) {
  for (Vec3& p : mesh.positions) {
    p = {static_cast<double>(static_cast<float>(p.x)), static_cast<double>(static_cast<float>(p.y)),
         static_cast<double>(static_cast<float>(p.z))};
  }
  return mesh;
}

/// New numbers 0 to count - 1 in an order that the seed decides.
inline std::vector<Index> shuffled_numbers(std::size_t count, std::uint64_t seed) {
  std::vector<Index> numbers(count);
  for (std::size_t k = 0; k < count; ++k)
    numbers[k] = static_cast<Index>(k);
  Random random(seed);
  for (std::size_t k = count; k > 1; --k) {
    const double share = 0.5 * (random.number() + 1.0);
    std::swap(numbers[k - 1], numbers[static_cast<std::size_t>(share * static_cast<double>(k))]);
  }
  return numbers;
}

/// Other numbers for vertices and triangles, and other first corners.
inline TriMesh renumbered(const TriMesh& mesh, std::uint64_t seed = 7) {
  const auto vertex = shuffled_numbers(mesh.positions.size(), seed);
  const auto triangle = shuffled_numbers(mesh.triangles.size(), seed + 1);
  TriMesh other = mesh;
  for (std::size_t v = 0; v < vertex.size(); ++v)
    other.positions[vertex[v]] = mesh.positions[v];
  for (std::size_t t = 0; t < triangle.size(); ++t) {
    const auto [a, b, c] = mesh.triangles[t];
    other.triangles[triangle[t]] = {vertex[a], vertex[b], vertex[c]};
    std::rotate(other.triangles[triangle[t]].begin(),
                other.triangles[triangle[t]].begin() + triangle[t] % 3,
                other.triangles[triangle[t]].end());
  }
  return other;
}

}  // namespace planish::meshes
