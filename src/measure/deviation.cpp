#include <algorithm>
#include <cmath>

#include <planish/measure/deviation.h>

#include "core/careful_sum.h"

namespace planish {

Deviation measure_deviation(const TriMesh& before, std::span<const Vec3> after,
                            const Connectivity& connectivity) {
  const double scale = unit_scale(before);
  CarefulSum squares;
  double largest = 0.0, n = 0.0;
  for (Index v = 0; v < connectivity.vertex_count(); ++v) {
    if (!connectivity.is_inner(v) && after[v] == before.positions[v]) continue;
    const Vec3 moved = scale * after[v] - scale * before.positions[v];
    squares.add(dot(moved, moved));
    largest = std::max(largest, norm(moved));
    n += 1.0;
  }
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
