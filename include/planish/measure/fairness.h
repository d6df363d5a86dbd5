#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <planish/measure/form_change.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// An inner edge with its two triangles: from, to, left and to, from, right.
struct Hinge {
  Index from, to;     ///< from < to
  Index left, right;  ///< the third corners of the triangles
};

/// All hinges, by `from` and then in the order of its ring. O(n).
std::vector<Hinge> hinges_of(const Patch& patch);

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

/// Angle, length and area of a hinge with its vertices at these positions.
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
Bending measure_bending(const Patch& patch);

/// How sharply a surface is bent at each vertex, one over model units: the mean |curvature| across
/// its inner edges by their areas, |k1| + |k2| or up to 1.7 times that, by how the edges lie; 0
/// where there is no such edge. O(n).
std::vector<double> vertex_bends(const Patch& patch);

/// The mean curvature (k1 + k2) / 2 of every inner vertex, one over model units, positive where the
/// surface is convex seen from outside: 1/R on a sphere. Minus the sum of t l / 4 over its edges,
/// over a third of the area of its triangles; 0 for all other vertices and where there is no area.
/// O(n).
std::vector<double> vertex_mean_curvatures(const Patch& patch);

/// Less than this is a plane and rounding: a surface that turns by a millionth of a radian.
inline constexpr double k_no_bending = 1e-12;

/// The edge at which a surface is folded most beyond what its design is there.
struct Fold {
  Index from = 0, to = 0;  ///< the edge's vertices
  /// How much sharper it is bent, degrees: |t1| - |t0|; |t1| where valley and ridge changed
  /// sides.
  double degrees = 0.0;
  Vec3 at = {};  ///< the middle of the edge on the surface, model units
};

/// How smooth a surface is beside the design that it was made from; nothing of it depends on the
/// size of the model, and hardly anything on the density of the mesh (docs/fairness.md).
struct Fairness {
  /// B / B0: bending over design_bending(). None where the design is a plane.
  std::optional<double> bending_ratio = {};
  /// The same of the design: above 1 by the short waves of its noise.
  double design_ratio = 1.0;
  /// Bending that came and went, edge by edge, each over B0: with k0 and k1 the curvatures across
  /// an edge, (|k1| - |k0|)^2 of its area where their signs agree; where they do not, all of k1
  /// came and all of k0 went. A fold counts as added, a flattened dome as lost. None where the
  /// design is a plane or has other triangles. Noise of a scan (find_scan_noise()) is no form: then
  /// the lost one is that of both surfaces smoothed, away from the border.
  std::optional<double> bending_added = {}, bending_lost = {};
  /// Share of the area, 0 to 1, that is bent more sharply than 99 % of the design: at most 0.01 for
  /// the design itself.
  double sharp_share = 0.0;
  /// sharp_share of the design itself.
  double design_sharp_share = 0.0;
  /// Turn of the vertex normals, and of the normals of the triangles along the border, against the
  /// design; rms, degrees. None where the design has other triangles.
  std::optional<double> normal_turn = {}, border_turn = {};
  /// None where nothing is bent more sharply, or the design has other triangles.
  std::optional<Fold> sharpest_fold = {};
  /// Height over the design's: of the corners, along the direction in which the design extends
  /// least. None where the design is lower than k_least_height.
  std::optional<double> height_ratio = {};
  /// The largest move of a vertex over the diagonal of the design's bounding box. None where the
  /// design has other triangles.
  std::optional<double> largest_move = {};
  /// What a person sees of the change. None where the design has other triangles.
  std::optional<FormChange> form_change = {};
  bool unchanged = false;  ///< the design itself, to the last digit

  /// Whether a person sees no ripples and no fold that the design does not have: the one rule of
  /// everything that says smooth. By form_change; without it, bends_little(). The design itself is
  /// smooth; beside a plane nothing else is.
  bool is_smooth() const;
  /// Whether it is one that a search keeps: bending_ratio, bending_added and sharp_share within
  /// k_smooth_*, where a design with noise may have a larger bending_ratio and its result the same.
  bool bends_little() const;
  /// Whether bending_ratio is known and at most this, or the design's own where that is more; true
  /// of the design itself.
  bool bends_at_most(double ratio) const;
  /// What a surface that is sought has to be: bends_at_most(max_bending) where such a bound
  /// was asked for (Auto::max_bending), bends_little() where none was: 0. What searches go by.
  bool is_smooth_within(double max_bending) const;
  /// Whether a person would call it the same design: form_change has no dent and lost neither
  /// relief nor edge, height_ratio is not below k_kept_height, and largest_move within k_kept_move.
  /// The one rule of everything that says so; what is not known is taken as kept.
  bool keeps_form() const;
};

/// Largest bending_ratio of what bends little.
inline constexpr double k_smooth_ratio = 1.3;
/// Largest bending_added of what bends little.
inline constexpr double k_smooth_added = 1.0;
/// Largest sharp_share of what bends little.
inline constexpr double k_smooth_sharp_share = 0.04;
/// Of the height of the design three quarters stay at least.
inline constexpr double k_kept_height = 0.75;
/// No place is further from its design than a tenth of the diagonal.
inline constexpr double k_kept_move = 0.1;
/// A design has a height where it extends by this share of its longest extent at least.
inline constexpr double k_least_height = 0.02;

/// Compares a surface with its design, vertex by vertex. O(n log n).
/// @param after one position per vertex of `design`
Fairness measure_fairness(const Patch& design, std::span<const Vec3> after);

/// The same of a surface with other triangles: ratio, sharp share and height only.
Fairness measure_fairness(const Patch& design, const Patch& after);

/// The design beside itself, as measure_fairness() would find it, from what a result of it has.
Fairness fairness_of_design(const Fairness& of_result);

/// Where a surface goes through itself.
struct SelfIntersections {
  /// Pairs of triangles without a vertex in common of which an edge of one goes through the inside
  /// of the other. What touches or lies flat on itself does not count, nor what rounding could
  /// have made.
  std::size_t pairs = 0;
  /// The first pair, by the lower and then the higher number, and where it crosses.
  struct Place {
    std::array<Index, 2> triangles;  ///< the lower number first
    Vec3 at;                         ///< model units
  };
  std::optional<Place> first = {};  ///< none where nothing crosses
  /// False where so many triangles lie upon one another that the search was given up: then `pairs`
  /// is only what had been found.
  bool complete = true;
};

/// The same result every time. O(n log n) for surfaces; given up after so many steps a triangle
/// that only what is no surface needs more.
SelfIntersections find_self_intersections(const TriMesh& mesh);

}  // namespace planish
