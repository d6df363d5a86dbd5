#pragma once

#include <optional>

#include <planish/core/vec.h>

#include "evolve/state/patch_state.h"
#include "mesh/search/signed_distance.h"

namespace planish {

/// Where vertices may go: outside the obstacle, not too far from where they began. In the units of
/// the patch's state, which must outlive it.
class AllowedMoves {
 public:
  /// @param clearance least distance from the obstacle
  /// @param radius largest distance from the origin
  AllowedMoves(const PatchState& state, double clearance, double radius);

  /// Nearer to the obstacle than the clearance, or in it.
  bool is_too_near(Vec3 p) const { return obstacle_ && obstacle_->at(p).value < clearance_; }

  /// The half-space { step : normal step >= least } that keeps a vertex at x away from the
  /// obstacle, to first order; none where it is further away than `reach`.
  struct HalfSpace {
    Vec3 normal;
    double least;
  };
  std::optional<HalfSpace> half_space(Vec3 x, double reach) const;

  /// Where the vertex goes that is at x and is to make the move. Not further than `longest`, and
  /// never nearer to the obstacle than the clearance, or than x where that is nearer.
  Vec3 target_of(Index v, Vec3 x, Vec3 move, double longest) const;

 private:
  Vec3 away_from_obstacle(Vec3 from, Vec3 target, double longest) const;

  const PatchState& state_;
  double clearance_, radius_;
  std::optional<SignedDistance> obstacle_;
};

}  // namespace planish
