#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>

#include "geometry/angle_between.h"
#include "geometry/curve_size.h"

namespace planish {

/// The sum of the angles of the triangles at a border vertex, radians.
/// @param scale that of unit_scale(), so that products of lengths stay in range
inline double border_angle(std::span<const Vec3> positions, const Connectivity& connectivity,
                           double scale, Index b) {
  const auto ring = connectivity.ring(b);  // open
  const auto spoke = [&](std::size_t j) {
    return scale * positions[ring[j]] - scale * positions[b];
  };
  double sum = 0.0;
  for (std::size_t j = 0; j + 1 < ring.size(); ++j)
    sum += angle_between(spoke(j), spoke(j + 1));
  return sum;
}

/// How far a loop of the border turns to the left on the surface, radians: 2 pi around a flat
/// patch, -2 pi around a hole in it, 0 at the end of a cylinder.
inline double border_turning(std::span<const Vec3> positions, const Connectivity& connectivity,
                             double scale, std::span<const Index> loop) {
  double turning = 0.0;
  for (const Index b : loop)
    turning += std::numbers::pi - border_angle(positions, connectivity, scale, b);
  return turning;
}

/// Whether a loop of the border that is not the outer one is the end of a tube, not a hole: it is
/// more than half a turn from closing in the plane.
inline bool is_tube_end(double turning) {
  return !(std::abs(turning + 2.0 * std::numbers::pi) <= std::numbers::pi);
}

/// Whether the sides of a loop lie on each other, as where a seam of the mesh is not joined: it
/// encloses nothing.
inline bool is_slit(std::span<const Vec3> positions, double scale, std::span<const Index> loop) {
  constexpr double k_open = 1e-5;  // of the squared length: above what rounded coordinates leave
  std::vector<Vec3> places;
  places.reserve(loop.size());
  for (const Index v : loop)
    places.push_back(scale * positions[v]);
  const double length = scale * size_of_loop(positions, loop).length;
  return enclosed_area(places) <= k_open * length * length;
}

}  // namespace planish
