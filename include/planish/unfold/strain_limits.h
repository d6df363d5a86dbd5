#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include <planish/mesh/connectivity.h>

namespace planish {

/// How much a pattern may stretch or shrink, as shares of length; 0 where there is no limit.
struct StrainLimits {
  double max = 0.0;  ///< for the |strain| of every edge
  double p99 = 0.0;  ///< for the |strain| on 99 % of the area
  double rms = 0.0;  ///< for the root mean square of the strain

  bool any() const { return max > 0.0 || p99 > 0.0 || rms > 0.0; }
  bool operator==(const StrainLimits&) const = default;
};

/// What a limit bounds.
enum class StrainLimitKind { max, p99, rms };
std::string_view to_string(StrainLimitKind kind);

/// A limit that was asked for beside what a pattern has.
struct StrainLimitCheck {
  StrainLimitKind kind = StrainLimitKind::max;
  double asked = 0.0, reached = 0.0;
  double share_beyond = 0.0;       ///< of the area; more strain than `asked`
  std::array<Index, 2> edge = {};  ///< the first edge with the largest |strain|, by its vertices
  Vec3 at = {};                    ///< the middle of that edge on the patch, model units

  bool kept() const { return reached <= asked; }
};

/// One for each limit, in the order of StrainLimitKind.
/// @param pattern one position per vertex of the mesh
std::vector<StrainLimitCheck> check_limits(const TriMesh& mesh, const Connectivity& connectivity,
                                           std::span<const Vec2> pattern,
                                           const StrainLimits& limits);

/// True if the pattern keeps all of them.
bool all_kept(std::span<const StrainLimitCheck> checks);

}  // namespace planish
