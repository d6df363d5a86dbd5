#pragma once

#include <planish/mesh/patch.h>

namespace planish {

/// R: how far a surface is from having straight lines (rulings) through every place, as developable
/// surfaces have; 0 to 1/2. After Stein, Grinspun, Crane 2018, "Developability of triangle meshes":
/// at an inner vertex the sum over its triangles of corner angle x n n^T, n the unit normal, with
/// eigenvalues l1 <= l2 <= l3; R = sum l1 / sum (l1 + l2) over inner vertices. Near 0 where the
/// normals around each vertex lie in one plane: on cylinders and cones whose edges follow the
/// rulings (up to 0.15 where they do not); 1/2 on a sphere. 0 for a plane. O(n).
double ruling_defect(const Patch& patch);

}  // namespace planish
