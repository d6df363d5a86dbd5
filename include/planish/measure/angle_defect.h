#pragma once

#include <vector>

#include <planish/mesh/connectivity.h>

namespace planish {

/// d_v = 2 pi - theta_v of every inner vertex, in radians; 0 for all other vertices. Zero-area
/// triangles have angles 0, 0, pi. Angles come from the product of the corners as complex numbers:
/// one arctangent a vertex and no loss of digits near 2 pi (docs/notation.md).
std::vector<double> angle_defects(const TriMesh& mesh, const Connectivity& connectivity);

}  // namespace planish
