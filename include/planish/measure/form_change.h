#pragma once

#include <planish/core/vec.h>

namespace planish {

/// What a person sees of a change of form, beside the design: figures of windows, parts of the
/// surface around places that lie evenly on it, as wide as a share of the size of the design. None
/// depends on size or place, and hardly any on the density of the mesh. Short waves that the design
/// has itself, as noise, do not count; they hide no longer waves that are new. The bounds are
/// fitted to what two reviews said of pictures (docs/fairness.md).
struct FormChange {
  /// How much more a window is bent than in the design: the root of the bending that came in it
  /// (less that which went) over what the design has there and in its calm parts; 0.6 of that along
  /// the border. On 99 % of the area at most.
  double ripple = 0.0;
  /// The most of it in one window, and where, model units of the result.
  double fold = 0.0;
  Vec3 fold_at = {};  ///< the middle of that window
  /// How far the middle of a window went along the normal beyond the whole window, which may shift
  /// and tilt, over its radius: on 98 % of the area at most, and the place of the largest.
  double dent = 0.0;
  Vec3 dent_at = {};  ///< the place of the largest, model units of the result
  /// How unevenly the normals of a window turned, degrees: beyond a turn that changes evenly from
  /// place to place, and beyond 0.3 of how unevenly they lie in the design. On 98 % of the area at
  /// most.
  double uneven_turn = 0.0;
  /// Share of the height that windows lost which stand out of a plane: on 60 % of their area at
  /// least; more than 1 where hills became hollows. 0 where nothing stands out.
  double relief_lost = 0.0;
  /// Share of the turn that windows with an edge lost: on 70 % of their area at most. 0 where there
  /// are no edges, or too few to be seen.
  double edge_lost = 0.0;

  /// Waves, wrinkles or many folds.
  bool is_rippled() const;
  /// A fold, crease or small dent in one place.
  bool is_folded() const;
  /// A wide dent or bulge.
  bool is_dented() const;
  /// A small feature is gone, blurred or new.
  bool is_uneven() const;
  /// A hill or hollow is gone.
  bool has_lost_relief() const;
  /// An edge is rounded off.
  bool has_lost_edge() const;
};

/// Above it a person sees a ripple: bent 1.24 times as sharply.
inline constexpr double k_seen_ripple = 0.73;
/// Above it a person sees a new fold.
inline constexpr double k_seen_new_fold = 2.7;
/// Above it a person sees a dent.
inline constexpr double k_seen_dent = 0.0255;
/// Above it, degrees, a person sees that a small feature changed.
inline constexpr double k_seen_uneven_turn = 2.6;
/// Above it a person misses a hill or hollow.
inline constexpr double k_seen_relief_lost = 0.22;
/// Above it a person misses an edge.
inline constexpr double k_seen_edge_lost = 0.46;

}  // namespace planish
