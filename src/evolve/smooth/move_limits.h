#pragma once

#include <vector>

#include "evolve/descent/border_motion.h"
#include "evolve/descent/descent_limits.h"
#include "evolve/systems/kkt_system.h"

namespace planish {

/// Slows moves that come near a limit of distance, so that steps need not be cut, and keeps moves
/// of the border smooth along it: with u the moves, r the limits, m of such vertices and bends,
///
///     0.3 mean (|u| / (0.85 r))^8 + mean |second difference of u|^2 / (0.04 h)^2,
///
/// h the mean edge.
class MoveLimits {
 public:
  /// @param unit h
  MoveLimits(const DescentLimits& limits, const BorderMotion& border, std::size_t inner_count,
             double unit);

  /// @param moves by column of the jacobian
  double value(const Positions& moves) const;
  /// Adds stiff times the second derivatives, and takes the gradient from the force.
  void add_to(KktSystem& system, Positions& force, const Positions& moves, double stiff) const;
  /// True if a vertex is nearly as far as it may be.
  bool is_reached(const Positions& moves) const;

 private:
  Vec3 bend_of(const BorderMotion::Bend& bend, const Positions& moves) const;

  std::vector<double> reach_;   // by column; infinite where there is no limit
  std::vector<double> weight_;  // one over how many have a limit of the kind
  std::vector<BorderMotion::Bend> bends_;
  double bend_weight_ = 0.0;
};

}  // namespace planish
