#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <planish/mesh/surface_line.h>

#include "core/math.h"
#include "mesh/carry/place_on_triangle.h"
#include "mesh/search/closest_point.h"

namespace planish {

Vec3 position_of(const SurfacePoint& place, std::span<const Vec3> positions) {
  return place.shares[0] * positions[place.corners[0]] +
         place.shares[1] * positions[place.corners[1]] +
         place.shares[2] * positions[place.corners[2]];
}

Vec2 position_of(const SurfacePoint& place, std::span<const Vec2> positions) {
  return place.shares[0] * positions[place.corners[0]] +
         place.shares[1] * positions[place.corners[1]] +
         place.shares[2] * positions[place.corners[2]];
}

double jag_of(std::span<const Vec3> line, double edge) {
  constexpr double edges = 4.0;
  std::vector<double> along = {0.0};
  for (std::size_t i = 1; i < line.size(); ++i)
    along.push_back(along.back() + norm(line[i] - line[i - 1]));
  const double whole = along.back(), parts = std::round(whole / (edges * edge));
  if (!(parts >= 2.0) || !std::isfinite(parts)) return 1.0;
  double chords = 0.0;
  Vec3 before = line.front();
  std::size_t i = 1;
  for (double k = 1.0; k <= parts; k += 1.0) {
    const double at = k < parts ? k / parts * whole : whole;
    while (i + 1 < line.size() && along[i] < at)
      ++i;
    const double step = along[i] - along[i - 1];
    const double share = step > 0.0 ? (at - along[i - 1]) / step : 1.0;
    const Vec3 here = line[i - 1] + share * (line[i] - line[i - 1]);
    chords += norm(here - before);
    before = here;
  }
  return whole / chords;
}

SurfacePoint nearest_place(const Patch& patch, Vec3 point) {
  if (patch.triangles().empty()) throw Error(ErrorCode::no_triangles, "the mesh has no triangles");
  if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z))
    throw Error(ErrorCode::non_finite_coordinate, "a place has a coordinate that is no number");
  const double scale = patch.unit_scale();
  const ClosestPoint closest = ClosestPointTree(scaled(patch.mesh(), scale)).query(scale * point);
  return {patch.triangles()[closest.triangle], cleared(closest.barycentric)};
}

SurfaceLine line_along_edges(const Patch& patch, std::span<const Index> path) {
  SurfaceLine line;
  for (const Index v : path) {
    const auto ring = patch.ring(v);
    line.push_back({{v, ring[0], ring[1]}, {1.0, 0.0, 0.0}});
  }
  return line;
}

double length_of(std::span<const SurfacePoint> line, std::span<const Vec3> positions) {
  double length = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec3 step = position_of(line[i], positions) - position_of(line[i - 1], positions);
    length += math::hypot(step.x, step.y, step.z);
  }
  return length;
}

}  // namespace planish
