#include <cmath>

#include <planish/measure/fairness.h>

#include "core/neumaier_sum.h"
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

namespace {

/// At each vertex the sum of a figure over the edges of it, over the area around those edges: 2/3
/// of that of its triangles. 0 where there is no area.
template <class Figure>
std::vector<double> per_area(const Patch& patch, const Figure& figure) {
  const double scale = patch.unit_scale();
  std::vector<double> sums(patch.vertex_count(), 0.0), areas(sums);
  for_each_bend(patch.positions(), patch.connectivity(), scale,
                [&](const Hinge& hinge, const Bend& bend) {
                  for (const Index v : {hinge.from, hinge.to}) {
                    sums[v] += figure(bend);
                    areas[v] += bend.area;
                  }
                });
  for (std::size_t v = 0; v < sums.size(); ++v)
    sums[v] = areas[v] > 0.0 ? scale * (sums[v] / areas[v]) : 0.0;
  return sums;
}

}  // namespace

std::vector<double> vertex_bends(const Patch& patch) {
  return per_area(patch, [](const Bend& bend) { return std::abs(bend.angle) * bend.length; });
}

std::vector<double> vertex_mean_curvatures(const Patch& patch) {
  auto curvatures =
      per_area(patch, [](const Bend& bend) { return -0.5 * bend.angle * bend.length; });
  for (Index v = 0; v < curvatures.size(); ++v) {
    if (!patch.is_inner(v)) curvatures[v] = 0.0;
  }
  return curvatures;
}

Bending measure_bending(const Patch& patch) {
  const double scale = patch.unit_scale();
  NeumaierSum bending, turning;
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
