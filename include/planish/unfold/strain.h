#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// Strain of all edges: length in the pattern over length on the patch, minus 1. In rms and p99 an
/// edge counts by a third of the area of its triangles on the patch, so that they do not depend on
/// where the mesh is fine.
struct EdgeStrain {
  double max = 0.0;                      ///< largest |strain|
  double rms = 0.0;                      ///< root mean square of the strain
  double p99 = 0.0;                      ///< |strain| that edges of 99 % of the area do not exceed
  std::array<Index, 2> worst_edge = {};  ///< vertices of the first edge with the largest |strain|
};

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

/// The largest limit of strain that can be asked for, a share of length: an edge twice as long.
inline constexpr double k_largest_strain_limit = 1.0;

/// How much a pattern may stretch or shrink, as shares of length; 0 where there is no limit.
struct StrainLimits {
  double max = 0.0;  ///< for the |strain| of every edge
  double p99 = 0.0;  ///< for the |strain| on 99 % of the area
  double rms = 0.0;  ///< for the root mean square of the strain

  /// Whether there is any limit.
  bool any() const { return max > 0.0 || p99 > 0.0 || rms > 0.0; }
  bool operator==(const StrainLimits&) const = default;
};

/// Every function that takes limits checks them by this.
/// @throws Error option_out_of_range: each limit is from 0 to k_largest_strain_limit, and `max` and
///   `p99` are not given together
void require(const StrainLimits& limits);

/// What a limit bounds.
enum class StrainLimitKind { max, p99, rms };
/// "max", "p99" or "rms".
std::string_view to_string(StrainLimitKind kind);

/// A limit that was asked for beside what a pattern has.
struct StrainLimitCheck {
  StrainLimitKind kind = StrainLimitKind::max;  ///< what it bounds
  double asked = 0.0, reached = 0.0;  ///< the limit, or what the pattern has; shares of length
  double share_beyond = 0.0;          ///< of the area; more strain than `asked`
  std::array<Index, 2> edge = {};     ///< the first edge with the largest |strain|, by its vertices
  Vec3 at = {};                       ///< the middle of that edge on the patch, model units

  /// Whether the pattern keeps the limit.
  bool kept() const { return reached <= asked; }
};

/// One for each limit, in the order of StrainLimitKind.
/// @param pattern one position per vertex of the mesh
/// @throws Error as require()
std::vector<StrainLimitCheck> check_limits(const Patch& patch, std::span<const Vec2> pattern,
                                           const StrainLimits& limits);

/// True if the pattern keeps all of them.
bool all_kept(std::span<const StrainLimitCheck> checks);

}  // namespace planish
