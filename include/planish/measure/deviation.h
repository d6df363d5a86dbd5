#pragma once

#include <optional>
#include <span>

#include <planish/mesh/patch.h>

namespace planish {

/// How far vertices are from where they were, in model units: all inner vertices, and those of the
/// border that moved.
struct Deviation {
  double rms = 0.0;                ///< root mean square of the distances
  double max = 0.0;                ///< largest distance
  double rms_over_diagonal = 0.0;  ///< rms as a share of the bounding-box diagonal of `before`
};

/// @param after one position per vertex of `before`
Deviation measure_deviation(const Patch& before, std::span<const Vec3> after);

/// What became of a border that moved, in model units.
struct BoundaryChange {
  double max = 0.0;  ///< how far the vertex of it that moved furthest is from where it was
  double length_before = 0.0, length_after = 0.0;  ///< of all its edges
};

/// None where no vertex of the border moved.
/// @param after one position per vertex of `before`
std::optional<BoundaryChange> measure_border_change(const Patch& before,
                                                    std::span<const Vec3> after);

/// How far a surface is from another one with nearly the same border and other triangles: rms and
/// largest over the inner vertices of `before`, to the nearest place of `after`; the largest also
/// over the vertices of `after`, to `before`. Both have triangles. O(n log n) where they are near.
Deviation measure_surface_deviation(const Patch& before, const TriMesh& after);

}  // namespace planish
