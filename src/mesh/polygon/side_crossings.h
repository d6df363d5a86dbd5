#pragma once

#include <span>

#include <planish/core/vec.h>

namespace planish {

/// True if two sides of a closed polygon cross, each within the other; sides that only touch or lie
/// on each other do not. Time n log n.
/// @param polygon as OwnPlane gives it: then the answer is exact
bool has_crossing_sides(std::span<const Vec2> polygon);

}  // namespace planish
