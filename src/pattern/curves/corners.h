#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/pattern/piece_outline.h>

namespace planish {

/// The points at which a closed line has a corner, in order. The line turns there by at least 20
/// degrees, also when seen from a distance on both sides (the larger of 3 mm and 2.5 mean edges),
/// and most of what it turns over that distance it turns at the point. So neither jags of a border
/// of triangles nor tight bends are corners.
std::vector<std::size_t> corners_of(const Polygon& loop);

/// The line from each break to the next one, ends included, beginning at the first; without breaks
/// all around from the first point to it again.
/// @param loop at least one point
/// @param breaks points of it in order, as corners_of() has them
std::vector<Polygon> stretches_of(const Polygon& loop, std::vector<std::size_t> breaks);

/// A closed line without points that are where the one before is.
Polygon without_repeats(const Polygon& loop);

/// The length of an open line.
double length_of_line(std::span<const Vec2> points);

}  // namespace planish
