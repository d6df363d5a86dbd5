#pragma once

#include <array>
#include <span>
#include <vector>

#include <planish/measure/limit_check.h>
#include <planish/mesh/patch.h>

namespace planish {

/// @param pattern one position per vertex of the mesh
EdgeStrain edge_strain(const Patch& patch, std::span<const Vec2> pattern);

/// The largest |strain| of the edges of the border.
/// @param pattern one position per vertex of the mesh
/// @param free_edges are left out, as UnfoldOptions has them
double largest_border_strain(const Patch& patch, std::span<const Vec2> pattern,
                             std::span<const std::array<Index, 2>> free_edges = {});

/// The two principal stretches of a triangle, patch to pattern: 1 keeps length, 0.9 is 10 % shorter
/// in the pattern. max >= |min|; min is negative where the triangle is flipped.
struct PrincipalStretch {
  double max = 1.0, min = 1.0;  ///< stretch in the direction where it is largest or smallest
};

/// One per triangle; zero-area triangles count as not stretched.
std::vector<PrincipalStretch> principal_stretches(const TriMesh& mesh,
                                                  std::span<const Vec2> pattern);

/// The strain of larger size of each triangle, with its sign: > 0 longer in the pattern, < 0
/// shorter. What strain maps show.
std::vector<double> signed_strains(std::span<const PrincipalStretch> stretches);

/// One for each limit, in the order of Criterion.
/// @param pattern one position per vertex of the mesh
/// @throws Error as require()
std::vector<LimitCheck> check_limits(const Patch& patch, std::span<const Vec2> pattern,
                                     const StrainLimits& limits);

}  // namespace planish
