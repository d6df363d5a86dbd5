#pragma once

#include <limits>
#include <span>

#include <planish/pattern/piece_outline.h>

namespace planish {

inline constexpr double k_no_hit = std::numeric_limits<double>::infinity();

/// How far from a place, along a direction of length 1, the first line is met; at least `from`,
/// which may be negative. k_no_hit where there is none.
double first_hit(std::span<const Polygon> loops, Vec2 place, Vec2 direction, double from);

/// Whether a place is within the loops, by the rule of even and odd.
bool is_within(std::span<const Polygon> loops, Vec2 place);

}  // namespace planish
