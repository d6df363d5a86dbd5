#include <planish/measure/angle_defect.h>

#include "measure/angle_product.h"

namespace planish {

std::vector<double> angle_defects(const TriMesh& mesh, const Connectivity& connectivity) {
  const double scale = unit_scale(mesh);
  std::vector<double> defects(mesh.positions.size(), 0.0);
  for (const Index v : connectivity.inner_vertices()) {
    const Vec3 x = scale * mesh.positions[v];
    const auto ring = connectivity.ring(v);
    AngleProduct sum;
    Vec3 previous = scale * mesh.positions[ring.back()] - x;
    for (const Index j : ring) {
      const Vec3 next = scale * mesh.positions[j] - x;
      sum.add(corner_between(previous, next));
      previous = next;
    }
    defects[v] = sum.defect();
  }
  return defects;
}

}  // namespace planish
