#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/inspect.h>
#include <planish/mesh/patch.h>

namespace planish {

/// d_v = 2 pi - theta_v of every inner vertex, in radians; 0 for all other vertices. Zero-area
/// triangles have angles 0, 0, pi. Angles come from the product of the corners as complex numbers:
/// one arctangent a vertex and no loss of digits near 2 pi (docs/notation.md).
std::vector<double> angle_defects(const Patch& patch);

/// Gaussian curvature of every inner vertex as Eq. 1 of the 2010 paper has it: d_v over a third of
/// the area of the triangles around v, one over square model units. 0 for all other vertices;
/// where there is no area, 0 for defect 0 and infinite for others.
/// @param defects as from angle_defects()
std::vector<double> gaussian_curvatures(const Patch& patch, std::span<const double> defects);

/// How large a patch is.
struct PatchSize {
  Vec3 extent = {};            ///< of the bounding box of what triangles use, model units
  double area = 0.0;           ///< of all triangles, square model units
  double border_length = 0.0;  ///< of all border loops, model units
};

/// Extent, area and border of a patch. O(n).
PatchSize measure_size(const Patch& patch);

/// How far a patch is from flattenable. Defects are over inner vertices only; with none, 0.
struct Flattenability {
  double e_max = 0.0;           ///< max |d_v|, radians (Eq. 18)
  double e_avg = 0.0;           ///< mean |d_v|, radians (Eq. 19)
  double energy = 0.0;          ///< sum of d_v^2, square radians (Eq. 4)
  double sum_abs_defect = 0.0;  ///< sum of |d_v|, radians: does not depend on mesh density
  double min_angle = 0.0;       ///< smallest angle of a triangle, radians
  double roughness = 0.0;       ///< rms dihedral angle over inner edges, degrees
  /// The most that the border of a hole, laid out in the plane edge by edge, lacks of a whole turn,
  /// radians, and of coming back to where it begins, in lengths of it. 0 without holes.
  double hole_turning = 0.0, hole_gap = 0.0;
};

/// Measures a patch. Sums run in the order of the vertices: the same bits every time.
Flattenability measure(const Patch& patch);

/// The four figures of defects from defects that are at hand.
/// @param defects as from angle_defects(): what is not inner has 0
Flattenability summarise_defects(std::span<const double> defects, std::size_t inner_vertices);

/// True where the pattern will have no stretch worth cutting for: a topological disk, perhaps with
/// holes, with e_max <= k_flattenable_e_max and sum_abs_defect, hole_turning and hole_gap <=
/// k_flattenable_sum. The second bound is there
/// as e_max alone falls with mesh density on one and the same curved surface (docs/notation.md).
bool is_flattenable(const Flattenability& figures, const Inspection& inspection);
/// Largest e_max of what is flattenable, radians.
inline constexpr double k_flattenable_e_max = 1e-4;
/// Largest sum_abs_defect of what is flattenable, radians.
inline constexpr double k_flattenable_sum = 1e-2;

}  // namespace planish
