#pragma once

#include <planish/evolve/method.h>

#include "core/thread_pool.h"
#include "evolve/state/patch_state.h"
#include "evolve/state/sweep.h"

namespace planish {

/// The steps of `auto` where the surface is to stay smooth (docs/methods/smooth.md): SmoothDescent
/// from coarse to fine, and if all strain is to go, polishing for the last defects. State and pool
/// must outlive it.
Sweep make_smooth_sweep(const Auto& options, PatchState& state, ThreadPool& pool);

}  // namespace planish
