#include <vector>

#include <planish/measure/flattenability.h>

#include "measure/star_batches.h"

namespace planish {

std::vector<double> angle_defects(const Patch& patch) {
  const double scale = patch.unit_scale();
  std::vector<Site> sites;
  sites.reserve(patch.vertex_count());
  for (const Vec3 p : patch.positions())
    sites.push_back({scale * p.x, scale * p.y, scale * p.z, 0.0});
  std::vector<double> defects(patch.vertex_count(), 0.0);
  StarBatches batches(sites.data(), [&](Index v, double defect) { defects[v] = defect; });
  for (const Index v : patch.inner_vertices())
    batches.add(v, patch.ring(v));
  batches.finish();
  return defects;
}

}  // namespace planish
