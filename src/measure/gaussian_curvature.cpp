#include <cstddef>

#include <planish/measure/flattenability.h>

namespace planish {

std::vector<double> gaussian_curvatures(const TriMesh& mesh, const Connectivity& connectivity,
                                        std::span<const double> defects) {
  // Of a size where the products of coordinates can neither overflow nor vanish.
  const double scale = unit_scale(mesh);
  std::vector<double> areas(mesh.positions.size(), 0.0);
  for (const Triangle& triangle : mesh.triangles) {
    const Vec3 a = scale * mesh.positions[triangle[0]];
    const Vec3 b = scale * mesh.positions[triangle[1]];
    const Vec3 c = scale * mesh.positions[triangle[2]];
    const double area = 0.5 * norm(cross(b - a, c - a));
    for (const Index v : triangle)
      areas[v] += area;
  }
  std::vector<double> curvatures(mesh.positions.size(), 0.0);
  for (const Index v : connectivity.inner_vertices()) {
    if (defects[v] != 0.0) curvatures[v] = defects[v] / (areas[v] / 3.0) * scale * scale;
  }
  return curvatures;
}

}  // namespace planish
