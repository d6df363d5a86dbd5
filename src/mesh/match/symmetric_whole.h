#pragma once

#include <array>
#include <optional>
#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// A plane of mirror images.
struct MirrorPlane {
  Vec3 point, normal;  ///< the normal has length 1

  Vec3 mirrored(Vec3 p) const { return p - 2.0 * dot(p - point, normal) * normal; }
  Vec3 nearest(Vec3 p) const { return p - dot(p - point, normal) * normal; }
};

/// A half and its mirror image as one patch, welded along the fold. The half's vertices come first,
/// those of the fold moved into the plane.
struct SymmetricWhole {
  Patch patch;
  std::vector<Index> image;  ///< of each vertex of the half: its mirror image; on the fold itself
  MirrorPlane plane;
  std::size_t half_size() const { return image.size(); }
};

/// How far a fold may be off its plane, as a share of its length.
inline constexpr double k_most_off_plane = 1e-3;

/// The whole of which a patch is the half, cut along a stretch of its border that lies in a plane
/// but for k_most_off_plane of its length. Of the two stretches between the ends the shorter one
/// that does is meant. Nothing where none does, or where the halves have more than that in common.
/// @param ends vertices of the fold, in either order
std::optional<SymmetricWhole> symmetric_whole(const Patch& half, std::array<Index, 2> ends);

/// Positions of the half, where those of its mirror image are taken into account: the mean of both,
/// those of the fold in the plane.
std::vector<Vec3> half_of(const SymmetricWhole& whole, const std::vector<Vec3>& positions);

}  // namespace planish
