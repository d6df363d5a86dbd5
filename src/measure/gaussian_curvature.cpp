#include <cstddef>

#include <planish/measure/flattenability.h>

namespace planish {

std::vector<double> gaussian_curvatures(const Patch& patch, std::span<const double> defects) {
  // Of a size where the products of coordinates can neither overflow nor vanish.
  const double scale = patch.unit_scale();
  std::vector<double> areas(patch.vertex_count(), 0.0);
  for (const Triangle& triangle : patch.triangles()) {
    const Vec3 a = scale * patch.positions()[triangle[0]];
    const Vec3 b = scale * patch.positions()[triangle[1]];
    const Vec3 c = scale * patch.positions()[triangle[2]];
    const double area = 0.5 * norm(cross(b - a, c - a));
    for (const Index v : triangle)
      areas[v] += area;
  }
  std::vector<double> curvatures(patch.vertex_count(), 0.0);
  for (const Index v : patch.inner_vertices()) {
    if (defects[v] != 0.0) curvatures[v] = defects[v] / (areas[v] / 3.0) * scale * scale;
  }
  return curvatures;
}

}  // namespace planish
