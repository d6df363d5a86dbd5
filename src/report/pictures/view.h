#pragma once

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// How a patch is looked at, from far away: three directions at right angles, of length one.
struct View {
  Vec3 right, up;
  Vec3 towards;  ///< from the patch to the eye
};

/// Against the mean normal by area, tilted so that the form shows, with the longest extent of the
/// patch upright. Where the normals cancel out, along the direction of least extent.
View view_of(const TriMesh& mesh);

}  // namespace planish
