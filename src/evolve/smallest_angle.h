#pragma once

#include "evolve/patch_state.h"

namespace planish {

/// Of all triangles, as the patch is, in radians; infinite without triangles.
double smallest_angle(const PatchState& state);

/// Of a triangle in the numbers of the state.
double smallest_angle(const PatchState& state, const Triangle& triangle);

}  // namespace planish
