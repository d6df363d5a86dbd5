#include <vector>

#include <planish/measure/flattenability.h>

#include "measure/star_batches.h"

namespace planish {

std::vector<double> angle_defects(const TriMesh& mesh, const Connectivity& connectivity) {
  const double scale = unit_scale(mesh);
  std::vector<Site> sites;
  sites.reserve(mesh.positions.size());
  for (const Vec3 p : mesh.positions)
    sites.push_back({scale * p.x, scale * p.y, scale * p.z, 0.0});
  std::vector<double> defects(mesh.positions.size(), 0.0);
  StarBatches batches(sites.data(), [&](Index v, double defect) { defects[v] = defect; });
  for (const Index v : connectivity.inner_vertices())
    batches.add(v, connectivity.ring(v));
  batches.finish();
  return defects;
}

}  // namespace planish
