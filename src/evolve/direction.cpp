#include "evolve/direction.h"

#include <algorithm>
#include <cmath>

#include <planish/measure/flattenability.h>

#include "geometry/angle_gradient.h"
#include "geometry/laplacian.h"

namespace planish {

namespace {

// Errors of a defect, absolute and as a share of it, with room to spare.
constexpr double k_rounding = 1e-14, k_rounding_share = 1e-12;

/// Sums d_j theta_j' over the defects that b_v is made of.
struct SlopeSum {
  double slope = 0.0;
  double error = 0.0;  // what rounding can feign

  void add(double defect, double angle_rate) {
    slope += -2.0 * defect * angle_rate;
    error += 2.0 * (k_rounding + k_rounding_share * std::abs(defect)) * std::abs(angle_rate);
  }
};

VertexClass class_of(double defect, double flat) {
  if (std::abs(defect) <= flat) return VertexClass::flat;
  return defect > 0.0 ? VertexClass::dome_or_cup : VertexClass::saddle;
}

/// b_v'(0) = -2 sum of d theta' over v and its inner neighbours: only the angles of the triangles
/// at v change, each at the rate of its gradient in v along L.
/// @param positions of the vertices, at a scale where squares can neither overflow nor vanish
SlopeSum slope_at(Index v, std::span<const Vec3> positions, std::span<const double> defects,
                  const Connectivity& connectivity) {
  const std::span<const Index> ring = connectivity.ring(v);
  const std::size_t n = ring.size();
  const Vec3 x = positions[v];
  const Vec3 laplacian =
      edge_weighted_laplacian(x, n, [&](std::size_t j) { return positions[ring[j]]; });
  double own_rate = 0.0;
  std::vector<double> rates(n);
  for (std::size_t j = 0; j < n; ++j) {
    const std::size_t next = (j + 1) % n;
    const Vec3 a = positions[ring[j]], b = positions[ring[next]];
    own_rate += dot(laplacian, angle_gradient(x, a, b).at_p);
    rates[j] += dot(laplacian, angle_gradient(a, b, x).at_r);
    rates[next] += dot(laplacian, angle_gradient(b, x, a).at_q);
  }
  SlopeSum sum;
  sum.add(defects[v], own_rate);
  for (std::size_t j = 0; j < n; ++j) {
    if (connectivity.is_inner(ring[j])) sum.add(defects[ring[j]], rates[j]);
  }
  return sum;
}

}  // namespace

std::string_view to_string(VertexClass kind) {
  switch (kind) {
    case VertexClass::unused:
      return "unused";
    case VertexClass::border:
      return "border";
    case VertexClass::flat:
      return "flat";
    case VertexClass::dome_or_cup:
      return "dome_or_cup";
    case VertexClass::saddle:
      return "saddle";
  }
  return "unknown";
}

double flat_defect(std::size_t inner_vertices) {
  const double share =
      k_flattenable_sum / static_cast<double>(std::max<std::size_t>(1, inner_vertices));
  return std::min(k_flattenable_e_max, share);
}

std::vector<VertexDirection> laplacian_directions(const Patch& patch) {
  const std::vector<double> defects = angle_defects(patch);
  const double flat = flat_defect(patch.inner_vertices().size());
  const double scale = patch.unit_scale();
  std::vector<Vec3> positions;
  positions.reserve(patch.vertex_count());
  for (const Vec3 p : patch.positions())
    positions.push_back(scale * p);

  std::vector<VertexDirection> directions(patch.vertex_count());
  for (Index v = 0; v < directions.size(); ++v) {
    if (patch.is_border(v)) directions[v].kind = VertexClass::border;
  }
  for (const Index v : patch.inner_vertices()) {
    const SlopeSum sum = slope_at(v, positions, defects, patch.connectivity());
    directions[v] = {class_of(defects[v], flat), defects[v], sum.slope, sum.slope < -sum.error};
  }
  return directions;
}

DirectionCounts count_directions(std::span<const VertexDirection> directions) {
  DirectionCounts counts;
  for (const VertexDirection& direction : directions) {
    const VertexClass kind = direction.kind;
    if (kind == VertexClass::unused || kind == VertexClass::border) continue;
    ++counts.inner;
    if (kind == VertexClass::flat) ++counts.flat;
    if (kind == VertexClass::dome_or_cup) ++counts.dome_or_cup;
    if (kind == VertexClass::saddle) ++counts.saddle;
    if (direction.can_lower) ++counts.can_lower;
    if (!direction.can_lower && kind != VertexClass::flat) ++counts.stuck;
  }
  return counts;
}

}  // namespace planish
