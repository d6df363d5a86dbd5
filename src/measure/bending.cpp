#include <cmath>

#include <planish/measure/fairness.h>

#include "core/careful_sum.h"
#include "measure/area.h"
#include "measure/bends.h"

namespace planish {

std::vector<Hinge> hinges_of(const Patch& patch) {
  std::vector<Hinge> hinges;
  // About three edges a vertex.
  hinges.reserve(3 * patch.vertex_count());
  for_each_hinge(patch.connectivity(), [&](const Hinge& hinge) { hinges.push_back(hinge); });
  return hinges;
}

double Bend::curvature() const {
  return area > 0.0 ? angle * length / area : 0.0;
}

double Bend::bending() const {
  return curvature() * angle * length;
}

Bend bend_of(const Hinge& hinge, std::span<const Vec3> positions) {
  return bend_at(positions[hinge.from], positions[hinge.to], positions[hinge.left],
                 positions[hinge.right]);
}

std::vector<double> vertex_bends(const Patch& patch) {
  const double scale = patch.unit_scale();
  std::vector<double> bends(patch.vertex_count(), 0.0), areas(bends);
  for_each_bend(patch.positions(), patch.connectivity(), scale,
                [&](const Hinge& hinge, const Bend& bend) {
                  for (const Index v : {hinge.from, hinge.to}) {
                    bends[v] += std::abs(bend.angle) * bend.length;
                    areas[v] += bend.area;
                  }
                });
  for (std::size_t v = 0; v < bends.size(); ++v)
    bends[v] = areas[v] > 0.0 ? scale * (bends[v] / areas[v]) : 0.0;
  return bends;
}

std::vector<double> vertex_mean_curvatures(const Patch& patch) {
  const double scale = patch.unit_scale();
  std::vector<double> curvatures(patch.vertex_count(), 0.0), areas(curvatures);
  for_each_bend(patch.positions(), patch.connectivity(), scale,
                [&](const Hinge& hinge, const Bend& bend) {
                  for (const Index v : {hinge.from, hinge.to}) {
                    curvatures[v] -= bend.angle * bend.length;
                    areas[v] += bend.area;  // in all 2/3 of the area of its triangles
                  }
                });
  for (Index v = 0; v < curvatures.size(); ++v) {
    curvatures[v] =
        patch.is_inner(v) && areas[v] > 0.0 ? scale * (curvatures[v] / (2.0 * areas[v])) : 0.0;
  }
  return curvatures;
}

Bending measure_bending(const Patch& patch) {
  const double scale = patch.unit_scale();
  CarefulSum bending, turning;
  for_each_bend(patch.positions(), patch.connectivity(), scale,
                [&](const Hinge&, const Bend& bend) {
                  bending.add(bend.bending());
                  turning.add(std::abs(bend.angle) * bend.length);
                });
  const double area = area_of(patch.mesh(), scale);
  if (!(area > 0.0)) return {};
  return {bending.value(), 0.5 * turning.value() / std::sqrt(area)};
}

}  // namespace planish
