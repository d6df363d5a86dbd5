#pragma once

#include <span>
#include <vector>

#include <planish/mesh/connectivity.h>

namespace planish {

/// An inner edge with its two triangles: from, to, left and to, from, right.
struct Hinge {
  Index from, to;     ///< from < to
  Index left, right;  ///< the third corners of the triangles
};

/// All hinges, by `from` and then in the order of its ring. O(n).
std::vector<Hinge> hinges_of(const Connectivity& connectivity);

/// How a hinge is bent.
struct Bend {
  double angle = 0.0;   ///< between the normals, radians, -pi to pi; positive where it is a valley
                        ///< seen from outside; 0 where a triangle has no area
  double length = 0.0;  ///< of the edge
  double area = 0.0;    ///< its share of the surface: a third of its two triangles

  /// Across the edge, one over model units: angle x length / area; 0 where there is no area.
  double curvature() const;
  /// curvature()^2 x area = 3 angle^2 length^2 / (A1 + A2), its part of the bending.
  double bending() const;
};

Bend bend_of(const Hinge& hinge, std::span<const Vec3> positions);

/// How much a surface is bent in all; both figures are those of the surface, not of its triangles:
/// they do not change with the size of the model and hardly with the density of the mesh. Both say
/// nothing about how hard it is to lay flat: a cylinder is bent and flattenable.
struct Bending {
  /// B, the hinge energy (Grinspun, Hirani, Desbrun, Schroeder 2003): sum over inner edges of
  /// 3 t^2 l^2 / (A1 + A2). For triangles that are nearly equilateral the integral of
  /// 3 k1^2 + 3 k2^2 - 2 k1 k2, k1 and k2 the principal curvatures (docs/fairness.md).
  double bending = 0.0;
  /// M: half the sum of |t| l over the root of the area.
  double mean_curvature = 0.0;
};

/// Sums run in the order of hinges_of(): the same bits every time. O(n).
Bending measure_bending(const TriMesh& mesh, const Connectivity& connectivity);

/// How sharply a surface is bent at each vertex, one over model units: the mean |curvature| across
/// its inner edges by their areas, |k1| + |k2| or up to 1.7 times that, by how the edges lie; 0
/// where there is no such edge. O(n).
std::vector<double> vertex_bends(const TriMesh& mesh, const Connectivity& connectivity);

/// Less than this is a plane and rounding: a surface that turns by a millionth of a radian.
inline constexpr double k_no_bending = 1e-12;

}  // namespace planish
