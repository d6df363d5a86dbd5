#include <planish/measure/angle_defect.h>

#include "measure/angle_product.h"

namespace planish {

std::vector<double> angle_defects(const TriMesh& mesh, const Connectivity& connectivity) {
  const double scale = unit_scale(mesh);
  std::vector<double> defects(mesh.positions.size(), 0.0);
  for (const Index v : connectivity.inner_vertices()) {
    const auto ring = connectivity.ring(v);
    defects[v] = star_defect(scale * mesh.positions[v], ring.size(),
                             [&](std::size_t j) { return scale * mesh.positions[ring[j]]; });
  }
  return defects;
}

}  // namespace planish
