#include <algorithm>
#include <cmath>

#include <planish/measure/deviation.h>

#include "core/careful_sum.h"
#include "mesh/search/closest_point.h"

namespace planish {

namespace {

/// Distances so far, in units that scale() makes.
struct Distances {
  CarefulSum squares;
  double largest = 0.0, count = 0.0;

  void add(double squared) {
    squares.add(squared);
    largest = std::max(largest, std::sqrt(squared));
    count += 1.0;
  }
};

Deviation deviation_of(const Distances& distances, const TriMesh& before, double scale) {
  Deviation deviation;
  if (distances.count == 0.0) return deviation;
  deviation.rms = std::sqrt(distances.squares.value() / distances.count) / scale;
  deviation.max = distances.largest / scale;
  const double diagonal = bounding_box_diagonal(before);
  if (diagonal > 0.0) deviation.rms_over_diagonal = deviation.rms / diagonal;
  return deviation;
}

TriMesh scaled(TriMesh mesh, double scale) {
  for (Vec3& p : mesh.positions)
    p = scale * p;
  return mesh;
}

}  // namespace

Deviation measure_deviation(const TriMesh& before, std::span<const Vec3> after,
                            const Connectivity& connectivity) {
  const double scale = unit_scale(before);
  Distances distances;
  for (Index v = 0; v < connectivity.vertex_count(); ++v) {
    if (!connectivity.is_inner(v) && after[v] == before.positions[v]) continue;
    const Vec3 moved = scale * after[v] - scale * before.positions[v];
    distances.add(dot(moved, moved));
  }
  return deviation_of(distances, before, scale);
}

std::optional<BoundaryChange> measure_border_change(const TriMesh& before,
                                                    std::span<const Vec3> after,
                                                    const Connectivity& connectivity) {
  const double scale = unit_scale(before);
  const auto length = [scale](Vec3 from, Vec3 to) {
    return norm(scale * to - scale * from) / scale;
  };
  const std::vector<Vec3>& origins = before.positions;
  BoundaryChange change;
  for (const auto& loop : connectivity.border_loops()) {
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

Deviation measure_surface_deviation(const TriMesh& before, const TriMesh& after) {
  const double scale = unit_scale(before);
  const TriMesh first = scaled(before, scale), second = scaled(after, scale);
  Distances distances;
  const ClosestPointTree to_second(second);
  const Connectivity connectivity(before);
  for (const Index v : connectivity.inner_vertices())
    distances.add(to_second.query(first.positions[v]).squared_distance);
  const ClosestPointTree to_first(first);
  for (const Vec3 p : second.positions) {
    const double distance = std::sqrt(to_first.query(p).squared_distance);
    distances.largest = std::max(distances.largest, distance);
  }
  return deviation_of(distances, before, scale);
}

}  // namespace planish
