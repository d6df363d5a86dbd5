#pragma once

#include <span>
#include <vector>

#include <planish/mesh/connectivity.h>

namespace planish {

/// Gaussian curvature of every inner vertex as Eq. 1 of the 2010 paper has it: d_v over a third of
/// the area of the triangles around v, one over square model units. 0 for all other vertices;
/// where there is no area, 0 for defect 0 and infinite for others.
/// @param defects as from angle_defects()
std::vector<double> gaussian_curvatures(const TriMesh& mesh, const Connectivity& connectivity,
                                        std::span<const double> defects);

}  // namespace planish
