#include <algorithm>
#include <cmath>

#include <planish/mesh/tri_mesh.h>

#include "core/math.h"
#include "geometry/box.h"

namespace planish {

namespace {

Box bounding_box(const TriMesh& mesh) {
  Box box;
  // Vertices are marked first and looked at once each, in their order in memory.
  std::vector<unsigned char> used(mesh.positions.size(), 0);
  for (const Triangle& triangle : mesh.triangles) {
    for (const Index v : triangle)
      used[v] = 1;
  }
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (used[v] != 0) box.add(mesh.positions[v]);
  }
  return box;
}

// Halves, so that the difference of two huge numbers of opposite sign stays finite.
Vec3 half_extent(const TriMesh& mesh) {
  if (mesh.triangles.empty()) return {};
  const Box box = bounding_box(mesh);
  return 0.5 * box.high - 0.5 * box.low;
}

}  // namespace

double bounding_box_diagonal(const TriMesh& mesh) {
  const Vec3 half = half_extent(mesh);
  return 2.0 * math::hypot(half.x, half.y, half.z);
}

double unit_scale(const TriMesh& mesh) {
  return unit_scale(bounding_box(mesh));
}

double unit_scale(const Box& box) {
  const Vec3 half = 0.5 * box.high - 0.5 * box.low;
  const double extent = std::max({half.x, half.y, half.z});
  if (!(extent > 0.0) || !std::isfinite(extent)) return 1.0;
  const double farthest =
      std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.low.z), std::abs(box.high.x),
                std::abs(box.high.y), std::abs(box.high.z)});
  int exponent = 0, farthest_exponent = 0;
  std::frexp(extent, &exponent);  // extent = f * 2^exponent, f in [0.5, 1)
  std::frexp(farthest, &farthest_exponent);
  // A small patch far out must not be scaled out of range.
  const int largest = std::min(1022, 1022 - farthest_exponent);
  return std::ldexp(1.0, std::clamp(-exponent - 1, -1022, largest));
}

TriMesh scaled(TriMesh mesh, double factor) {
  for (Vec3& p : mesh.positions)
    p = factor * p;
  return mesh;
}

}  // namespace planish
