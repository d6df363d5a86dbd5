#pragma once

#include <span>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// A polyline as a machine takes it: places rounded to whole steps (and counted in steps), without
/// points that are nowhere and without repeats; of a closed one the last is not the first.
/// @param per_millimetre steps
std::vector<Vec2> whole_steps(std::span<const Vec2> line, double per_millimetre, bool closed);

}  // namespace planish
