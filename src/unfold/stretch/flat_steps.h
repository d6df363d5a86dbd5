#pragma once

#include <algorithm>
#include <vector>

#include "unfold/disk/disk.h"

namespace planish {

/// The vertex half way around the outer border from the first one.
inline Index opposite_of_first(const Disk& disk) {
  return disk.outer_border()[disk.outer_border().size() / 2];
}

/// The flat disk turned and shifted so that the first border vertex is at the origin, and the one
/// half way around on the x axis.
std::vector<Vec2> turn_to_axis(const Disk& disk, std::vector<Vec2> flat);

/// The symmetric Dirichlet energy of all triangles; infinite where one has no positive area.
inline double total_energy(const Disk& disk, const std::vector<Vec2>& flat) {
  return symmetric_dirichlet(disk.triangles, disk.rest, flat);
}

/// The share of a step at which the first triangle loses its area; infinite if none does.
double step_to_first_flip(const Disk& disk, const std::vector<Vec2>& flat,
                          const std::vector<Vec2>& step);

/// The largest size of a step to try: the whole one, or 90 % of that to the first flip.
inline double first_trial(const Disk& disk, const std::vector<Vec2>& flat,
                          const std::vector<Vec2>& step) {
  return std::min(1.0, 0.9 * step_to_first_flip(disk, flat, step));
}

/// Of what the slope foretells, a step has to gain this fraction (Armijo 1966); trials at most.
inline constexpr double k_armijo = 1e-4;
inline constexpr int k_most_trials = 40;

/// The positions after a share of a step.
std::vector<Vec2> moved(std::vector<Vec2> flat, double share, const std::vector<Vec2>& step);

}  // namespace planish
