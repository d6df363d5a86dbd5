#pragma once

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// How a patch is looked at, from far away: three directions at right angles, of length one.
struct View {
  Vec3 right, up;
  Vec3 towards;  ///< from the patch to the eye
};

/// Against the mean normal by area, turned so that the patch lies level and fills an upright
/// picture, its longer side to the right. The eye is lifted from there so that the form shows: a
/// little for shallow patches, more for high ones. Where the normals cancel out, along the
/// direction of least extent.
View view_of(const TriMesh& mesh);

/// Which axis of a model points up.
enum class UpAxis { y, z };

/// How a product stands before the eye: seen from its front, a little from the right and from
/// above. The front of a model is towards z where y is up, against y where z is.
View standing_view(UpAxis up);

}  // namespace planish
