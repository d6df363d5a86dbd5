#pragma once

#include <functional>
#include <vector>

#include "core/thread_pool.h"
#include "unfold/disk/disk.h"
#include "unfold/stretch/stretch_system.h"

namespace planish {

struct LeastStretch {
  std::vector<Vec2> flat;
  int iterations = 0;
  bool converged = false;
};

/// Minimises the symmetric Dirichlet energy from a start without flipped triangles, and keeps it
/// without: projected Newton steps, each cut short of the first flip and then until the energy
/// falls. Once the projected Hessian is factored, steps come from conjugate gradients on the full
/// one, preconditioned by that factor, until it no longer serves.
/// @param system of the disk, whose border is free
/// @param after_step called after each step; what it throws is passed on
LeastStretch minimise_stretch(const Disk& disk, StretchSystem& system, std::vector<Vec2> start,
                              int max_iterations, const std::function<void()>& after_step);

}  // namespace planish
