#pragma once

#include <array>

#include <planish/core/vec.h>

namespace planish {

/// Where c is, seen along the line from a to b: above 0 to the left, below 0 to the right, 0 on the
/// line. Exact where coordinates are whole numbers up to 2^51.
int side_of(Vec2 a, Vec2 b, Vec2 c);

/// Which diagonal of a quad makes the better triangles.
enum class Diagonal { through_first, through_second, either };

/// The diagonal of the Delaunay triangulation of a quad: that whose opposite angles have the
/// smaller sum. Either, where the sums differ by less than a thousandth of the smallest angle or
/// so: what the rounding of a file could turn is not decided by it.
/// @param quad counter-clockwise
Diagonal better_diagonal(const std::array<Vec2, 4>& quad);

}  // namespace planish
