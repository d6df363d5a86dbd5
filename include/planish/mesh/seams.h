#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// A stretch of the border of a patch.
struct SeamSide {
  std::size_t patch = 0;  ///< its number in what find_seams() was given, from 0
  /// Of the patch, from end to end; a closed one ends as it begins. Where an end lies within an
  /// edge, both vertices of that edge are among them.
  std::vector<Index> vertices;
  double first_share = 0.0;  ///< of the first edge, 0 to below 1: where the side begins on it
  double last_share = 1.0;   ///< of the last edge, above 0 to 1: where the side ends on it
};

/// A curve that two borders share, or a border with itself, as the sides of a dart: as long as it
/// can be.
struct Seam {
  std::array<SeamSide, 2> sides;  ///< of two patches, or of one
  /// Empty where both sides have as many vertices, which lie at the same places one by one. Else
  /// the sides are matched as curves: places of both that lie beside each other, as shares of the
  /// sides' lengths, each at least as large as the one before, from 0, 0 to 1, 1.
  std::vector<std::array<double, 2>> matches = {};

  /// Whether the sides are matched as curves.
  bool is_curve() const { return !matches.empty(); }
};

/// Finds the seams of patches: by patches, then along the first side's border. Where more than two
/// borders share a curve, there is a seam for every two of them. Sides whose vertices lie at the
/// same places come first; where that leaves a curve matched in part only, the sides are matched as
/// curves: each vertex with the nearest place of the other border, within the tolerance and in
/// nearly the same direction. Such a seam has five edges or more on its finer side and is longer
/// than 0.2 % of the shorter border and 25 times the distance that nine tenths of its places keep.
/// There is none between two sides that have seams with equal vertices of their own. O(n log n) in
/// the vertices of borders.
/// @param tolerance the largest distance of borders that are one curve, and of vertices at the same
///   place, which are nearer than a tenth of the borders' mean edge too. It counts up to 25 edges.
///   0: vertices at exactly equal places, and curves within a tenth of the length of the edge that
///   a vertex lies beside, or of that of a longer neighbour.
/// @throws Error as Patch
std::vector<Seam> find_seams(std::span<const TriMesh> patches, double tolerance = 0.0);

/// The share of the second side's length, 0 to 1, at the place that lies beside a share of the
/// first one's; between matched places in proportion. Of sides with equal vertices the same share.
double matched_share(const Seam& seam, double share);

/// Borders that lie beside each other without being a seam: too short, too ragged or farther apart
/// than the tolerance.
struct NearBorders {
  std::array<std::size_t, 2> patches;  ///< the lower number first; the same for one border's sides
  double length = 0.0;                 ///< along which they do, model units
};

/// Finds such borders by patches. An edge lies beside another border if both of its vertices do,
/// or if a vertex of that border is beside it: within a tenth of the length of an edge or of a
/// longer neighbour, in nearly the same direction. Fewer than eight edges are left out.
/// @param seams what find_seams() found among the patches
/// @throws Error as Patch
std::vector<NearBorders> find_near_borders(std::span<const TriMesh> patches,
                                           std::span<const Seam> seams);

/// Length of a side on its patch.
double length_of(const SeamSide& side, std::span<const Vec3> positions);
/// Length of a side in the pattern of its patch.
double length_of(const SeamSide& side, std::span<const Vec2> pattern);

/// The side as a line, with its ends where they are, on its patch.
std::vector<Vec3> line_of(const SeamSide& side, std::span<const Vec3> positions);
/// The same in the pattern of its patch.
std::vector<Vec2> line_of(const SeamSide& side, std::span<const Vec2> pattern);

}  // namespace planish
