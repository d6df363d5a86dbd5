#pragma once

#include <planish/unfold/unfold.h>

#include "core/thread_pool.h"
#include "unfold/disk/disk.h"
#include "unfold/stretch/held_border.h"
#include "unfold/stretch/least_stretch.h"

namespace planish {

/// The flat disk of least stretch among those that keep the limits of edges; where there is none,
/// one that comes near to it.
/// @param border whose lengths stay kept; nullptr where the border is free
/// @param least of least stretch; it is returned as it is where it keeps the limits
LeastStretch unfold_within_limits(const TriMesh& mesh, const Disk& disk, const HeldBorder* border,
                                  const LeastStretch& least, const StrainLimits& limits,
                                  int max_iterations, ThreadPool& pool,
                                  const std::function<void()>& after_step);

/// The smallest limit of all |strain| that is found to be kept.
double smallest_limit_of(const TriMesh& mesh, const Disk& disk, std::vector<Vec2> least,
                         int max_iterations, ThreadPool& pool,
                         const std::function<void()>& after_step);

}  // namespace planish
