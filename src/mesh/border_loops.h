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
  const auto at = [&](Index v) { return scale * positions[v]; };
  return open_angle_sum(at(b), connectivity.ring(b), at);
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

/// What the border loops of one part of a mesh are, by their numbers. A loop that turns by -2 pi,
/// or as much within half a turn, closes in the plane as a hole.
struct BorderKinds {
  std::size_t outline = 0;             ///< the largest that is no hole; of holes alone the largest
  std::vector<std::size_t> tube_ends;  ///< the others that are no holes, increasing
};

/// Of the loops of one part, at least one.
/// @param turnings,sizes of each loop; turnings as border_turning() gives them
inline BorderKinds border_kinds(std::span<const double> turnings,
                                std::span<const CurveSize> sizes) {
  BorderKinds kinds;
  for (std::size_t k = 0; k < turnings.size(); ++k) {
    const bool closes = std::abs(turnings[k] + 2.0 * std::numbers::pi) <= std::numbers::pi;
    if (!closes) kinds.tube_ends.push_back(k);
  }
  if (kinds.tube_ends.empty()) return {outer_loop(sizes), {}};
  std::vector<CurveSize> of_ends;
  for (const std::size_t k : kinds.tube_ends)
    of_ends.push_back(sizes[k]);
  const auto largest = kinds.tube_ends.begin() + static_cast<std::ptrdiff_t>(outer_loop(of_ends));
  kinds.outline = *largest;
  kinds.tube_ends.erase(largest);
  return kinds;
}

/// @pre there is a loop; the mesh is of one part
inline BorderKinds border_kinds(std::span<const Vec3> positions, const Connectivity& connectivity,
                                double scale) {
  const auto& loops = connectivity.border_loops();
  if (loops.size() == 1) return {};
  std::vector<double> turnings;
  turnings.reserve(loops.size());
  for (const std::vector<Index>& loop : loops)
    turnings.push_back(border_turning(positions, connectivity, scale, loop));
  return border_kinds(turnings, sizes_of_loops(positions, loops, scale));
}

/// The numbers of the loops around holes, of a patch that can be laid flat as it is; none where it
/// has to be cut open.
inline std::vector<std::size_t> hole_loops(const Patch& patch) {
  std::vector<std::size_t> holes;
  const std::size_t count = patch.border_loops().size();
  if (count < 2 || blocking_problem(patch.inspection(), Purpose::unfold)) return holes;
  const std::size_t outline =
      border_kinds(patch.positions(), patch.connectivity(), patch.unit_scale()).outline;
  for (std::size_t k = 0; k < count; ++k) {
    if (k != outline) holes.push_back(k);
  }
  return holes;
}

/// Whether the sides of a loop lie on each other, as where a seam of the mesh is not joined: it
/// encloses nothing.
inline bool is_slit(std::span<const Vec3> positions, double scale, std::span<const Index> loop) {
  constexpr double k_open = 1e-5;  // of the squared length: above what rounded coordinates leave
  std::vector<Vec3> places;
  places.reserve(loop.size());
  for (const Index v : loop)
    places.push_back(scale * positions[v]);
  const double length = size_of_loop(positions, loop, scale).length;
  return enclosed_area(places) <= k_open * length * length;
}

}  // namespace planish
