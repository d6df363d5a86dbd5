#include "evolve/auto/shared/descent_limits.h"

#include <algorithm>
#include <numbers>

#include "evolve/auto/shared/smallest_angle.h"
#include "evolve/auto/shared/tuning.h"

namespace planish {

namespace {

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

}  // namespace

double angle_to_keep(const Auto& options, const PatchState& state, ThreadPool& pool) {
  if (options.min_angle > 0.0) return radians(options.min_angle);
  return std::min(radians(tuning::k_needle), 0.5 * smallest_angle(state, state.triangles(), pool));
}

DescentLimits limits_on(const PatchState& level, const Auto& options, double angle) {
  return {level.scale() * options.max_deviation,
          angle,
          {options.border.rule, level.scale() * options.border.distance}};
}

}  // namespace planish
