#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include <planish/mesh/tri_mesh.h>

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

/// What a result can miss: first what was asked for, then what every pattern must have.
enum class Criterion {
  strain,              ///< the limit on the |strain| of every edge
  p99_strain,          ///< the limit on the |strain| of 99 % of the area
  rms_strain,          ///< the limit on the root mean square of the strain
  stretch,             ///< the limit on the stretch of the sheet at every edge
  p99_stretch,         ///< the limit on its stretch on 99 % of the area
  compression,         ///< the limit on the compression of the sheet at every edge
  p99_compression,     ///< the limit on its compression on 99 % of the area
  deviation,           ///< the limit on how far vertices move
  angle,               ///< the limit on the smallest angle
  e_max,               ///< the target of e_max
  bending,             ///< the limit on bending
  rejected,            ///< evolving stretched the pattern more, so the design is the result
  failure,             ///< there is no result
  size,                ///< the pattern is too small to be a piece in the unit given
  stretched,           ///< the form was changed without a limit of strain and does not lie flat
  crumpled,            ///< the form is rippled or crumpled
  form,                ///< the form is not kept: hills, hollows, edges or height lost, or dented
  fold,                ///< the form has a new fold in one place
  self_intersections,  ///< the form intersects itself more than the design does
  overlap,             ///< the pattern overlaps itself
  flipped_triangles,   ///< triangles of the pattern are flipped over
};
/// The word of JSON and Python: "p99_strain".
std::string_view to_string(Criterion criterion);

/// Those that StrainLimits has limits for, in order.
inline constexpr std::array k_strain_criteria = {
    Criterion::strain,      Criterion::p99_strain,  Criterion::rms_strain,     Criterion::stretch,
    Criterion::p99_stretch, Criterion::compression, Criterion::p99_compression};
/// Whether it is one of those.
constexpr bool is_of_strain(Criterion what) {
  return what <= Criterion::p99_compression;
}

/// The name of the member of EdgeStrain and StrainLimits: "max", "p99_stretch" and so on.
/// @pre is_of_strain(what), here and below
std::string_view figure_name(Criterion what);

/// The figure of a pattern that a limit of strain bounds.
double figure_of(const EdgeStrain& strain, Criterion what);

/// The largest limit of strain that can be asked for, a share of length: an edge twice as long.
inline constexpr double k_largest_strain_limit = 1.0;

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

  /// The limit that is named.
  double& of(Criterion what);
  /// The limit that is named.
  double of(Criterion what) const;
  /// Whether there is any limit.
  bool any() const;
  /// Whether there is one for edges: any but that of the rms.
  bool bounds_edges() const;
  /// The limit of the |strain| that asks for as much of a form as these: what a pattern has of
  /// stretch and compression is shared out by its size, so that the mean of both limits counts.
  /// On 99 % of the area, or of every edge where no limit is for that; 0 where one side is free,
  /// as a pattern can be made small or large enough.
  double both_ways() const;
  /// What the form of a surface can be led to: both_ways() for every edge, and the rms.
  StrainLimits of_form() const { return {.max = both_ways(), .rms = rms}; }
  /// Whether a pattern with these figures keeps all of them.
  bool kept_by(const EdgeStrain& strain) const;
  bool operator==(const StrainLimits&) const = default;
};

/// Every function that takes limits checks them by this.
/// @throws Error option_out_of_range: each limit is from 0 to k_largest_strain_limit
void require(const StrainLimits& limits);

/// A limit or target that was asked for, and whether the result keeps it.
struct LimitCheck {
  Criterion what = Criterion::strain;  ///< that is limited; one of those up to `bending`
  double limit = 0.0;         ///< a share of length, model units, degrees, radians, a ratio
  double value = 0.0;         ///< what the result has: the largest, of angles the smallest
  bool met = value <= limit;  ///< of angles: value >= limit
  double share_beyond = 0.0;  ///< of strain in a pattern: of the area, with more than the limit
  /// Of strain in a pattern: the first edge with the largest |strain|, or most stretch or
  /// compression where that is limited.
  std::array<Index, 2> edge = {};
  Vec3 at = {};  ///< the middle of that edge on the patch, model units
};

/// One for each limit, in the order of Criterion; where is not known.
std::vector<LimitCheck> check_limits(const EdgeStrain& strain, const StrainLimits& limits);

/// True if all are met.
bool all_kept(std::span<const LimitCheck> checks);

}  // namespace planish
