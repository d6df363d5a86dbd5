#pragma once

#include <array>
#include <span>
#include <vector>

#include <planish/mesh/connectivity.h>

namespace planish {

/// Strain of all edges: length in the pattern over length on the patch, minus 1. In rms and p99 an
/// edge counts by a third of the area of its triangles on the patch, so that they do not depend on
/// where the mesh is fine.
struct EdgeStrain {
  double max = 0.0;  ///< largest |strain|
  double rms = 0.0;
  double p99 = 0.0;                      ///< |strain| that edges of 99 % of the area do not exceed
  std::array<Index, 2> worst_edge = {};  ///< vertices of the first edge with the largest |strain|
};

/// @param pattern one position per vertex of the mesh
EdgeStrain edge_strain(const TriMesh& mesh, const Connectivity& connectivity,
                       std::span<const Vec2> pattern);

/// The largest |strain| of the edges of the border.
/// @param pattern one position per vertex of the mesh
double largest_border_strain(const TriMesh& mesh, const Connectivity& connectivity,
                             std::span<const Vec2> pattern);

/// The two principal stretches of a triangle, patch to pattern: 1 keeps length, 0.9 is 10 % shorter
/// in the pattern. max >= |min|; min is negative where the triangle is flipped.
struct PrincipalStretch {
  double max = 1.0, min = 1.0;
};

/// One per triangle; zero-area triangles count as not stretched.
std::vector<PrincipalStretch> principal_stretches(const TriMesh& mesh,
                                                  std::span<const Vec2> pattern);

/// The strain of larger size of each triangle, with its sign: > 0 longer in the pattern, < 0
/// shorter. What strain maps show.
std::vector<double> signed_strains(std::span<const PrincipalStretch> stretches);

}  // namespace planish
