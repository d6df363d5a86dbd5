#pragma once

#include <vector>

#include <planish/mesh/connectivity.h>

namespace planish {

/// The places of all vertices when waves shorter than two mean edges are taken out of a surface:
/// the noise of a scan, not its form. Solves
///
///   (M + t L^T M^-1 L) x = M x0,  t = (h / pi)^4,  h the mean edge,
///
/// L the inner rows of the cotangent Laplacian, M a third of the area of the triangles around each
/// vertex: a wave of 2 h is halved, one of 4 h keeps 94 %. Border vertices stay where they are.
/// Linear time, by conjugate gradients to about five digits of the move.
std::vector<Vec3> smoothed_positions(const TriMesh& mesh, const Connectivity& connectivity);

/// B0: what bending is measured by beside a design: that of the smoothed design, so that noise does
/// not count for form; where needles make that more, that of the design as it is. 0 for a plane
/// (below k_no_bending). No unit.
double design_bending(const TriMesh& mesh, const Connectivity& connectivity);

}  // namespace planish
