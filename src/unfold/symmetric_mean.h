#pragma once

#include <span>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// One side of the symmetric layout that is nearest to one which is nearly so: the mean of each
/// place and of its partner's mirror image in the line that suits all. What is its own partner
/// comes to lie on that line.
/// @param partners of the places on the other side, one for each
std::vector<Vec2> symmetric_mean(std::vector<Vec2> places, std::span<const Vec2> partners);

}  // namespace planish
