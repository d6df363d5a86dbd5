#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// Strain of all edges: length in the pattern over length on the patch, minus 1. In rms and on 99 %
/// of the area an edge counts by a third of the area of its triangles on the patch, so that they do
/// not depend on where the mesh is fine.
///
/// Below 0 the pattern is shorter than the form: the sheet has to be stretched there. Above 0 it is
/// longer: the sheet has to be compressed, or eased in. Both are shares of the length on the form.
struct EdgeStrain {
  double max = 0.0;                      ///< largest |strain|
  double rms = 0.0;                      ///< root mean square of the strain
  double p99 = 0.0;                      ///< |strain| that edges of 99 % of the area do not exceed
  std::array<Index, 2> worst_edge = {};  ///< vertices of the first edge with the largest |strain|
  double max_stretch = 0.0;              ///< the largest stretch of the sheet
  double p99_stretch = 0.0;              ///< what edges of 99 % of the area do not exceed
  double max_compression = 0.0;          ///< the largest compression of the sheet
  double p99_compression = 0.0;          ///< what edges of 99 % of the area do not exceed
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

/// What a limit bounds: the figure of EdgeStrain that has its name.
enum class StrainLimitKind {
  max,              ///< |strain| of every edge
  p99,              ///< |strain| on 99 % of the area
  rms,              ///< root mean square of the strain
  max_stretch,      ///< stretch of every edge
  p99_stretch,      ///< stretch on 99 % of the area
  max_compression,  ///< compression of every edge
  p99_compression,  ///< compression on 99 % of the area
};
/// All of them, in order.
inline constexpr std::array k_strain_limit_kinds = {StrainLimitKind::max,
                                                    StrainLimitKind::p99,
                                                    StrainLimitKind::rms,
                                                    StrainLimitKind::max_stretch,
                                                    StrainLimitKind::p99_stretch,
                                                    StrainLimitKind::max_compression,
                                                    StrainLimitKind::p99_compression};
/// "max", "p99_stretch" and so on.
std::string_view to_string(StrainLimitKind kind);

/// The figure of a pattern that a limit of this kind bounds.
double figure_of(const EdgeStrain& strain, StrainLimitKind kind);

/// How much a pattern may stretch or shrink, as shares of length on the form; 0 where there is no
/// limit. Of several limits all are to be kept.
struct StrainLimits {
  double max = 0.0;              ///< for the |strain| of every edge
  double p99 = 0.0;              ///< for the |strain| on 99 % of the area
  double rms = 0.0;              ///< for the root mean square of the strain
  double max_stretch = 0.0;      ///< for the stretch of the sheet at every edge
  double p99_stretch = 0.0;      ///< for the stretch of the sheet on 99 % of the area
  double max_compression = 0.0;  ///< for the compression of the sheet at every edge
  double p99_compression = 0.0;  ///< for the compression of the sheet on 99 % of the area

  /// The limit of that kind.
  double& of(StrainLimitKind kind);
  /// The limit of that kind.
  double of(StrainLimitKind kind) const;
  /// Whether there is any limit.
  bool any() const;
  /// Whether there is one for edges: any but that of the rms.
  bool bounds_edges() const;
  /// The limit of the |strain| that asks for as much of a form as these: what a pattern has of
  /// stretch and compression is shared out by its size, so that the mean of both limits counts.
  /// On 99 % of the area, or of every edge where no limit is for that; 0 where one side is free,
  /// as a pattern can be made small or large enough.
  double both_ways() const;
  /// Whether a pattern with these figures keeps all of them.
  bool kept_by(const EdgeStrain& strain) const;
  bool operator==(const StrainLimits&) const = default;
};

/// Every function that takes limits checks them by this.
/// @throws Error option_out_of_range: each limit is from 0 to k_largest_strain_limit
void require(const StrainLimits& limits);

/// A limit that was asked for beside what a pattern has.
struct StrainLimitCheck {
  StrainLimitKind kind = StrainLimitKind::max;  ///< what it bounds
  double asked = 0.0, reached = 0.0;  ///< the limit, or what the pattern has; shares of length
  double share_beyond = 0.0;          ///< of the area; more strain than `asked`
  /// The first edge with the largest |strain|, or most stretch or compression where that is
  /// limited.
  std::array<Index, 2> edge = {};
  Vec3 at = {};  ///< the middle of that edge on the patch, model units

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
