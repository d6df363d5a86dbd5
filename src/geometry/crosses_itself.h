#pragma once

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <planish/core/vec.h>

#include "geometry/loop_order.h"

namespace planish {

/// True if two sides of a closed polygon that share no end cross each other. Sides that only touch,
/// as those of a slit do, do not count. Time n log n and n times the sides that a line meets.
bool crosses_itself(std::span<const Vec2> polygon);

/// The same of several closed polygons, whose sides must not cross each other either.
bool crosses_itself(std::span<const Vec2> points, const LoopOrder& loops);

/// Such sides, by the number of their first end, up to this number of pairs, in no special
/// order.
std::vector<std::pair<std::size_t, std::size_t>> crossing_sides(std::span<const Vec2> polygon,
                                                                std::size_t most);
std::vector<std::pair<std::size_t, std::size_t>> crossing_sides(std::span<const Vec2> points,
                                                                const LoopOrder& loops,
                                                                std::size_t most);

/// Where such sides cross, up to this number of places, in no special order.
std::vector<Vec2> self_crossings(std::span<const Vec2> polygon, std::size_t most);
std::vector<Vec2> self_crossings(std::span<const Vec2> points, const LoopOrder& loops,
                                 std::size_t most);

}  // namespace planish
