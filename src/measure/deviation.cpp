#include <algorithm>
#include <cmath>
#include <utility>

#include <planish/measure/deviation.h>

#include "core/neumaier_sum.h"
#include "mesh/search/closest_point.h"

namespace planish {

namespace {

/// Distances so far, in units that scale() makes.
struct Distances {
  NeumaierSum squares;
  double largest = 0.0, count = 0.0;

  void add(double squared) {
    squares.add(squared);
    largest = std::max(largest, std::sqrt(squared));
    count += 1.0;
  }
};

Deviation deviation_of(const Distances& distances, const Patch& before) {
  Deviation deviation;
  if (distances.count == 0.0) return deviation;
  const double scale = before.unit_scale();
  deviation.rms = std::sqrt(distances.squares.value() / distances.count) / scale;
  deviation.max = distances.largest / scale;
  const double diagonal = bounding_box_diagonal(before.mesh());
  if (diagonal > 0.0) deviation.rms_over_diagonal = deviation.rms / diagonal;
  return deviation;
}

}  // namespace

Deviation measure_deviation(const Patch& before, std::span<const Vec3> after) {
  const double scale = before.unit_scale();
  Distances distances;
  for (Index v = 0; v < before.vertex_count(); ++v) {
    const Vec3 from = before.positions()[v];
    if (!before.is_inner(v) && after[v] == from) continue;
    const Vec3 moved = scale * after[v] - scale * from;
    distances.add(dot(moved, moved));
  }
  return deviation_of(distances, before);
}

std::optional<BoundaryChange> measure_border_change(const Patch& before,
                                                    std::span<const Vec3> after) {
  const double scale = before.unit_scale();
  const auto length = [scale](Vec3 from, Vec3 to) {
    return norm(scale * to - scale * from) / scale;
  };
  const std::vector<Vec3>& origins = before.positions();
  BoundaryChange change;
  for (const auto& loop : before.border_loops()) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index v = loop[i], next = loop[i + 1 < loop.size() ? i + 1 : 0];
      change.max = std::max(change.max, length(origins[v], after[v]));
      change.length_before += length(origins[v], origins[next]);
      change.length_after += length(after[v], after[next]);
    }
  }
  if (change.max == 0.0) return std::nullopt;
  return change;
}

Deviation measure_surface_deviation(const Patch& before, const TriMesh& after) {
  const double scale = before.unit_scale();
  TriMesh first = scaled(before.mesh(), scale);
  const TriMesh second = scaled(after, scale);
  Distances distances;
  const ClosestPointTree to_second(second);
  for (const Index v : before.inner_vertices())
    distances.add(to_second.query(first.positions[v]).squared_distance);
  const ClosestPointTree to_first(std::move(first));
  for (const Vec3 p : second.positions) {
    const double distance = std::sqrt(to_first.query(p).squared_distance);
    distances.largest = std::max(distances.largest, distance);
  }
  return deviation_of(distances, before);
}

}  // namespace planish
