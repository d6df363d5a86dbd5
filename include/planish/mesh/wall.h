#pragma once

#include <optional>
#include <vector>

#include <planish/mesh/repair.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// What a triangle of a wall belongs to.
enum class WallPart : unsigned char {
  outer,  ///< the side whose normals point away from the other, of larger area
  inner,  ///< the other side
  rim,    ///< between the borders of both
};

/// A sheet that was given a thickness: two sides at a constant distance.
struct Wall {
  double thickness = 0.0;      ///< median distance of the sides, model units
  std::vector<WallPart> part;  ///< of each triangle
};

/// Recognises a wall: a closed thin shell, or two sheets that no triangle joins. Its sides face
/// away from each other, or both towards each other, at the same distance within a fifth on nine
/// tenths of their area, and they are more than eight times as large across as they are apart. Of
/// a flat wall the side with the first triangle is the outer one. A solid body is none. Nothing is
/// found in a mesh that is no oriented manifold.
std::optional<Wall> find_wall(const TriMesh& mesh);

/// One side of a wall, oriented away from the other, without its rim.
/// @param side outer or inner
RepairedMesh take_side(const TriMesh& mesh, const Wall& wall, WallPart side);

}  // namespace planish
