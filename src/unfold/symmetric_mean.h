#pragma once

#include <span>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// A symmetric layout near one which is nearly so: the mean of each place and of its partner's
/// mirror image in the line that suits all. What is its own partner comes to lie on that line.
/// @param partners of the places on the other side, one for each
/// @param shares of the partners in the means, 0 to 1; with that of the partner itself it is 1
std::vector<Vec2> symmetric_mean(std::vector<Vec2> places, std::span<const Vec2> partners,
                                 std::span<const double> shares);

}  // namespace planish
