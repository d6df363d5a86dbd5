#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// Normal to a triangle, as long as twice its area.
/// @param scale that positions are multiplied by, so that no area overflows: Patch::unit_scale()
inline Vec3 triangle_normal(const Triangle& t, std::span<const Vec3> positions, double scale) {
  const Vec3 a = scale * positions[t[0]];
  return cross(scale * positions[t[1]] - a, scale * positions[t[2]] - a);
}

/// At each vertex, also of the border, the sum over its triangles; not of length 1.
inline std::vector<Vec3> vertex_normals(std::span<const Triangle> triangles,
                                        std::span<const Vec3> positions, double scale) {
  std::vector<Vec3> normals(positions.size());
  for (const Triangle& t : triangles) {
    const Vec3 normal = triangle_normal(t, positions, scale);
    for (const Index v : t)
      normals[v] += normal;
  }
  return normals;
}

/// The same of length 1; zero where the normals of the triangles cancel.
inline std::vector<Vec3> unit_vertex_normals(std::span<const Triangle> triangles,
                                             std::span<const Vec3> positions) {
  std::vector<Vec3> normals = vertex_normals(triangles, positions, 1.0);
  for (Vec3& normal : normals) {
    const double length = norm(normal);
    normal = length > 0.0 ? (1.0 / length) * normal : Vec3{};
  }
  return normals;
}

/// How far each vertex went along the normals of the design, positive to their side; model units.
inline std::vector<double> normal_offsets(const Patch& design, std::span<const Vec3> after) {
  const double scale = design.unit_scale();
  const auto normals = vertex_normals(design.triangles(), design.positions(), scale);
  std::vector<double> offsets;
  offsets.reserve(normals.size());
  for (std::size_t v = 0; v < normals.size(); ++v) {
    const Vec3 moved = scale * after[v] - scale * design.positions()[v];
    const double length = norm(normals[v]);
    const Vec3 normal = length > 0.0 ? (1.0 / length) * normals[v] : Vec3{};
    offsets.push_back(dot(moved, normal) / scale);
  }
  return offsets;
}

}  // namespace planish
