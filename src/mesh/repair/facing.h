#pragma once

#include <optional>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// How the two sides of a wall are oriented.
enum class Facing : unsigned char {
  apart,     ///< both away from the other side, as a closed shell is
  towards,   ///< both towards the other side
  same_way,  ///< as a sheet and its copy, shifted
};

/// Triangles that face another one at one distance.
struct FacingTriangles {
  static constexpr Index none = static_cast<Index>(-1);

  Facing way = Facing::apart;
  double distance = 0.0;        ///< the median by area, in units of the mesh
  std::vector<Index> opposite;  ///< of each triangle; none where there is none near that distance
};

/// Sends a ray from each triangle and looks whether nearly all of their area meets another triangle
/// of nearly parallel normal at nearly the same distance, some twentieth of the extent or less.
/// @param mesh at the scale of unit_scale() and near the origin
std::optional<FacingTriangles> find_facing(const TriMesh& mesh);

}  // namespace planish
