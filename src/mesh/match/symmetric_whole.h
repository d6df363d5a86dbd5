#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include <planish/mesh/patch.h>
#include <planish/mesh/symmetry.h>

namespace planish {

/// A half and its mirror image as one patch, welded along the fold. The half's vertices come first,
/// those of the fold moved into the plane.
struct SymmetricWhole {
  Patch patch;
  std::vector<Index> image;  ///< of each vertex: its mirror image; on the fold itself
  Plane plane;               ///< its normal has length 1
  std::size_t half_size = 0;
};

/// Of the diagonal: vertices that are nearer to a plane of symmetry count as on it.
inline constexpr double k_on_plane = 1e-6;

/// How far a fold may be off its plane, as a share of its length.
inline constexpr double k_most_off_plane = 1e-3;

/// The whole of which a patch is the half, cut along a stretch of its border that lies in a plane
/// but for k_most_off_plane of its length. Of the two stretches between the ends the shorter one
/// that does is meant. Nothing where none does, or where the halves have more than that in common.
/// @param ends vertices of the fold, in either order
std::optional<SymmetricWhole> symmetric_whole(const Patch& half, std::array<Index, 2> ends);

/// A half with its mirror image behind it, welded along vertices that are moved into the plane.
/// @param is_welded of each vertex of the half
SymmetricMesh with_mirror_image(TriMesh half, const std::vector<bool>& is_welded,
                                const Plane& plane);

}  // namespace planish
