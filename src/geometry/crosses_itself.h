#pragma once

#include <span>

#include <planish/core/vec.h>

namespace planish {

/// True if two sides of a closed polygon that share no end cross each other. Sides that only touch,
/// as those of a slit do, do not count. Time n log n and n times the sides that a line meets.
bool crosses_itself(std::span<const Vec2> polygon);

}  // namespace planish
