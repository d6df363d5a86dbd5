#include <algorithm>
#include <limits>

#include <planish/measure/flattenability.h>

#include "core/neumaier_sum.h"
#include "measure/area.h"

namespace planish {

namespace {

Vec3 extent_of(const TriMesh& mesh, double scale) {
  if (mesh.triangles.empty()) return {};
  constexpr double far = std::numeric_limits<double>::infinity();
  Vec3 low = {far, far, far}, high = {-far, -far, -far};
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t) {
      const Vec3 p = scale * mesh.positions[v];
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
  }
  return (1.0 / scale) * (high - low);
}

double border_length_of(const Patch& patch, double scale) {
  NeumaierSum length;
  for (const auto& loop : patch.border_loops()) {
    Vec3 before = scale * patch.positions()[loop.back()];
    for (const Index b : loop) {
      const Vec3 here = scale * patch.positions()[b];
      length.add(norm(here - before));
      before = here;
    }
  }
  return length.value() / scale;
}

}  // namespace

PatchSize measure_size(const Patch& patch) {
  const double scale = patch.unit_scale();
  return {extent_of(patch.mesh(), scale), area_of(patch.mesh(), scale) / scale / scale,
          border_length_of(patch, scale)};
}

}  // namespace planish
