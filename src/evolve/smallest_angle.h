#pragma once

#include "evolve/patch_state.h"

namespace planish {

/// Of all triangles, as the patch is, in radians; infinite without triangles.
double smallest_angle(const PatchState& state);

}  // namespace planish
