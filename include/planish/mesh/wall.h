#pragma once

#include <array>
#include <optional>
#include <vector>

#include <planish/mesh/repair.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// What a triangle of a wall belongs to.
enum class WallPart : unsigned char {
  outer,  ///< the side that bulges
  inner,  ///< the other side
  rim,    ///< between the borders of both
};

/// A sheet that was given a thickness: two sides at a constant distance.
struct Wall {
  double thickness = 0.0;      ///< median distance of the sides, model units
  std::vector<WallPart> part;  ///< of each triangle
  /// Whether the outer and the inner side are oriented towards the other one in the mesh.
  std::array<bool, 2> turned{};
  /// Nothing tells the sides apart: it is flat, or bends one way as much as the other.
  bool is_level = false;
};

/// Recognises a wall: a closed thin shell, or two sheets that no triangle joins. On nine tenths of
/// their area its sides are at the same distance within a fifth, with normals that are parallel
/// within 30 degrees, and they are twenty times as large across as they are apart, or more. The
/// side that bulges is the outer one, by the bends that both sides have together, so rims and
/// bevels count for nothing; of a wall that is level the side with the first triangle. A solid body
/// is none. Nothing is found in a mesh that is no oriented manifold. A mesh may hold several walls
/// of one thickness.
std::optional<Wall> find_wall(const TriMesh& mesh);

/// One side of a wall, oriented away from the other, without its rim.
/// @param wall what find_wall() found in the mesh
/// @param side outer or inner; the rim is given as it is
RepairedMesh take_side(const TriMesh& mesh, const Wall& wall, WallPart side);

}  // namespace planish
