#include <algorithm>
#include <cmath>

#include <planish/measure/deviation.h>

#include "core/careful_sum.h"

namespace planish {

Deviation measure_deviation(const TriMesh& before, std::span<const Vec3> after,
                            const Connectivity& connectivity) {
  const double scale = unit_scale(before);
  CarefulSum squares;
  double largest = 0.0;
  for (const Index v : connectivity.inner_vertices()) {
    const Vec3 moved = scale * after[v] - scale * before.positions[v];
    squares.add(dot(moved, moved));
    largest = std::max(largest, norm(moved));
  }
  const auto n = static_cast<double>(connectivity.inner_vertices().size());
  Deviation deviation;
  if (n == 0.0) return deviation;
  const double rms = std::sqrt(squares.value() / n);
  deviation.rms = rms / scale;
  deviation.max = largest / scale;
  const double diagonal = bounding_box_diagonal(before);
  if (diagonal > 0.0) deviation.rms_over_diagonal = deviation.rms / diagonal;
  return deviation;
}

}  // namespace planish
