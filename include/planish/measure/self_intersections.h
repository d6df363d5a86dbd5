#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// Where a surface goes through itself.
struct SelfIntersections {
  /// Pairs of triangles without a vertex in common of which an edge of one goes through the inside
  /// of the other. What touches or lies flat on itself does not count, nor what rounding could
  /// have made.
  std::size_t pairs = 0;
  /// The first pair, by the lower and then the higher number, and where it crosses.
  struct Place {
    std::array<Index, 2> triangles;
    Vec3 at;  ///< model units
  };
  std::optional<Place> first = {};
  /// False where so many triangles lie upon one another that the search was given up: then `pairs`
  /// is only what had been found.
  bool complete = true;
};

/// The same result every time. O(n log n) for surfaces; given up after so many steps a triangle
/// that only what is no surface needs more.
SelfIntersections find_self_intersections(const TriMesh& mesh);

}  // namespace planish
