#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// A stretch of the border of a patch.
struct SeamSide {
  std::size_t patch = 0;        ///< its number in what find_seams() was given, from 0
  std::vector<Index> vertices;  ///< of the patch, from end to end; a closed one ends as it begins
};

/// A curve that two borders share, or a border with itself, as the sides of a dart: as long as it
/// can be. Both sides have as many vertices, which lie at the same places one by one.
struct Seam {
  std::array<SeamSide, 2> sides;  ///< of two patches, or of one
};

/// Finds the seams of patches: by patches, then along the first side's border. Where more than two
/// borders share a curve, there is a seam for every two of them.
/// @param tolerance borders' vertices this close are at the same place; 0: exactly equal ones only.
///   It should be far below the lengths of edges.
/// @throws Error as Patch
std::vector<Seam> find_seams(std::span<const TriMesh> patches, double tolerance = 0.0);

/// Borders that lie beside each other without being a seam, as their vertices are not at the same
/// places.
struct NearBorders {
  std::array<std::size_t, 2> patches;  ///< the lower number first; the same for one border's sides
  double length = 0.0;                 ///< along which they do, model units
};

/// Finds such borders by patches. An edge lies beside another border if that passes the edge's
/// middle within a tenth of the edge's length, in nearly the same direction. Fewer than eight edges
/// are left out.
/// @param seams what find_seams() found among the patches
/// @throws Error as Patch
std::vector<NearBorders> find_near_borders(std::span<const TriMesh> patches,
                                           std::span<const Seam> seams);

/// Length of a side on its patch.
double length_of(const SeamSide& side, std::span<const Vec3> positions);
/// Length of a side in the pattern of its patch.
double length_of(const SeamSide& side, std::span<const Vec2> pattern);

}  // namespace planish
