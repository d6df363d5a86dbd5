#pragma once

#include <optional>
#include <span>

#include <planish/mesh/connectivity.h>

namespace planish {

/// The edge at which a surface is folded most beyond what its design is there.
struct Fold {
  Index from = 0, to = 0;  ///< the edge's vertices
  /// How much sharper it is bent, degrees: |t1| - |t0|; |t1| where valley and ridge changed
  /// positions.
  double degrees = 0.0;
  Vec3 at = {};  ///< the middle of the edge on the surface, model units
};

/// How smooth a surface is beside the design that it was made from; nothing of it depends on the
/// size of the model, and hardly anything on the density of the mesh (docs/fairness.md).
struct Fairness {
  /// B / B0: bending over design_bending(). None where the design is a plane.
  std::optional<double> bending_ratio = {};
  /// Bending that came and went, edge by edge, each over B0: with k0 and k1 the curvatures across
  /// an edge, (|k1| - |k0|)^2 of its area where their signs agree; where they do not, all of k1
  /// came and all of k0 went. A fold counts as added, a flattened dome as lost. None where the
  /// design is a plane or has other triangles.
  std::optional<double> bending_added = {}, bending_lost = {};
  /// Share of the area, 0 to 1, that is bent more sharply than 99 % of the design: 0.01 for the
  /// design itself.
  double sharp_share = 0.0;
  /// Turn of the vertex normals, and of the normals of the triangles along the border, against the
  /// design; rms, degrees. None where the design has other triangles.
  std::optional<double> normal_turn = {}, border_turn = {};
  /// None where nothing is bent more sharply, or the design has other triangles.
  std::optional<Fold> sharpest_fold = {};
  bool unchanged = false;  ///< the design itself, to the last digit

  /// A designer would take it: bending_ratio, bending_added and sharp_share within k_smooth_*. The
  /// design itself is smooth; beside a plane nothing else is. What is not smooth is crumpled: the
  /// one rule of everything that says so.
  bool is_smooth() const;
  /// Whether it still bends where the design does: bending_lost within k_kept_lost; also where that
  /// is not known.
  bool keeps_form() const;
};

inline constexpr double k_smooth_ratio = 1.3;
inline constexpr double k_smooth_added = 1.0;
inline constexpr double k_smooth_sharp_share = 0.04;
/// Of the bending of the design half at most is gone.
inline constexpr double k_kept_lost = 0.5;

/// Compares a surface with its design, vertex by vertex. O(n log n).
/// @param connectivity that of `design`
/// @param after one position per vertex of `design`
Fairness measure_fairness(const TriMesh& design, const Connectivity& connectivity,
                          std::span<const Vec3> after);

/// The same of a surface with other triangles: ratio and sharp share only.
Fairness measure_fairness(const TriMesh& design, const TriMesh& after);

}  // namespace planish
