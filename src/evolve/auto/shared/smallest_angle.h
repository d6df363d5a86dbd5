#pragma once

#include <span>

#include "core/thread_pool.h"
#include "evolve/state/patch_state.h"

namespace planish {

/// Of triangles in the numbers of the state, as the patch is, in radians; infinite without
/// triangles.
double smallest_angle(const PatchState& state, std::span<const Triangle> triangles,
                      ThreadPool& pool);

/// The smallest angle of one triangle: the one opposite its shortest edge.
double smallest_angle(const PatchState& state, const Triangle& triangle);

}  // namespace planish
