#pragma once

#include <limits>

#include <planish/evolve/method.h>

#include "core/thread_pool.h"
#include "evolve/state/patch_state.h"

namespace planish {

/// What no step may break, in the units of the state and radians.
struct DescentLimits {
  double deviation = std::numeric_limits<double>::infinity();  ///< of a vertex from its origin
  double angle = 0.0;  ///< smallest of a triangle, or what it is at first if that is less
  BorderFreedom border = {};
};

/// The angle that `auto` keeps, radians: the option's, or else such that no new needles arise.
double angle_to_keep(const Auto& options, const PatchState& state, ThreadPool& pool);

/// Those of `auto` on a level.
DescentLimits limits_on(const PatchState& level, const Auto& options, double angle);

}  // namespace planish
