#pragma once

#include <planish/core/vec.h>

#include "geometry/angle_between.h"

namespace planish {

/// Angle between the normals of the two triangles at the edge from a to b, radians; 0 where one of
/// them has no area.
inline double dihedral_angle(Vec3 a, Vec3 b, Vec3 left, Vec3 right) {
  return angle_between(cross(b - a, left - a), cross(right - a, b - a));
}

}  // namespace planish
