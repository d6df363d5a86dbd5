#include "mesh/mean_edge.h"

#include <cstddef>

namespace planish {

double mean_edge_length(const TriMesh& mesh) {
  const double scale = unit_scale(mesh);
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i)
      sum += norm(scale * mesh.positions[t[(i + 1) % 3]] - scale * mesh.positions[t[i]]);
  }
  return sum / (3.0 * static_cast<double>(mesh.triangles.size())) / scale;
}

}  // namespace planish
