#pragma once

#include <planish/core/vec.h>

namespace planish {

/// @pre the vector is not 0
Vec2 direction_of(Vec2 v);

/// The angle from a to b, -pi to pi, > 0 where b is to the left.
double turn_between(Vec2 a, Vec2 b);

/// From one place to another one, of length 1; (0, 0) where both are the same.
Vec2 direction(Vec2 from, Vec2 to);

/// To the right of a direction: outside of a loop that has the piece on its left.
Vec2 outwards(Vec2 direction);

/// The distance of a place from the line between two points; these may be one.
double distance_to_segment(Vec2 p, Vec2 a, Vec2 b);

/// Whether directions, the first of length 1, are opposite but for 60 degrees, as those of the two
/// sides of a slit.
bool are_opposite(Vec2 unit, Vec2 other);

}  // namespace planish
