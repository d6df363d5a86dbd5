#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// Numbers as a page takes them: their bytes, lowest first, as base64.
std::string packed_floats(std::span<const double> values);  ///< of 32 bits
std::string packed_numbers(std::span<const Index> values);  ///< of 32 bits
/// Of 16 bits.
/// @pre no value is above 65535
std::string packed_small_numbers(std::span<const Index> values);

/// Points on a grid of 65536 places along each axis, from the lowest coordinates to the highest: no
/// coordinate is off by more than half a step, which is the extent along its axis over 131070.
/// Coordinates that are not finite are at the lowest place.
struct PackedPoints {
  std::vector<double> low, step;  ///< by axis
  std::vector<std::string> data;  ///< by list of points: 16 bits a coordinate, x y z x y z
};

/// Lists of points on one grid.
PackedPoints packed_points(std::span<const std::vector<Vec3>> lists);
PackedPoints packed_points(std::span<const Vec2> points);

}  // namespace planish
