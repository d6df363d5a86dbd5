#pragma once

#include <cstddef>
#include <numbers>
#include <optional>

#include <planish/mesh/patch.h>

namespace planish {

/// What the border of a disk demands of a flattenable surface that spans it: how much area it may
/// have, and how its border must turn (docs/obstruction.md). Of the patch as it is; a larger
/// deviation, other triangles or another method cannot help where the border forbids, only another
/// border can: a dart or a cut. Lengths in model units, angles in radians.
struct Obstruction {
  double area = 0.0;           ///< of the patch
  double border_length = 0.0;  ///< l
  /// No flattenable surface with this border has more: l^2 / (4 pi), the isoperimetric bound; where
  /// has_flat_border(), what the border encloses.
  double area_limit = 0.0;
  double area_excess = 0.0;   ///< area that must go at least; 0 where none must
  double excess_share = 0.0;  ///< the same as a share of the area, 0 to 1

  double total_defect = 0.0;    ///< sum of d_v over inner vertices
  double border_turning = 0.0;  ///< sum of pi - theta_b; with total_defect 2 pi (Gauss-Bonnet)
  /// How far the border can turn at most on any surface: its total curvature as a curve in space,
  /// as theta_b is at least the angle between the two border edges. At least 2 pi (Fenchel).
  double turning_most = 0.0;
  std::size_t border_vertices = 0;  ///< how many there are
  /// Border vertices at which every triangle has its three corners on the border, as at an ear:
  /// their angle is the same whatever the inner vertices do.
  std::size_t fixed_angles = 0;

  /// No flattenable surface with this border has as much area as the patch.
  bool blocked() const { return excess_share > 0.0; }

  /// The border lies in a plane and is convex there, up to 1e-5 rad: then every angle theta_b of a
  /// flattenable surface is the least that it can be, and the plane piece is the only such surface.
  bool has_flat_border() const;

  /// So much area must go that nobody could take it up as stretch: more than k_notable_excess.
  bool is_notable() const;
};

/// How far the border of a flat disk turns: total_defect is what it lacks.
inline constexpr double k_flat_turning = 2.0 * std::numbers::pi;

/// 1 % of the area is 0.5 % of every length, which leather and cloth take up as stretch.
inline constexpr double k_notable_excess = 0.01;

/// Nothing where the question does not arise: of what is not one disk (one component, one border
/// loop, no handle). The share does not depend on the model's size. O(n + m).
std::optional<Obstruction> find_obstruction(const Patch& patch);

}  // namespace planish
