#pragma once

#include <span>
#include <vector>

#include <planish/core/vec.h>

#include "core/thread_pool.h"
#include "geometry/box.h"

namespace planish {

/// The box of the chosen positions.
Box bounding_box(std::span<const Vec3> positions, std::span<const Index> chosen, ThreadPool& pool);

/// The numbers of `chosen` sorted along a space-filling curve (Morton) through their positions:
/// vertices near in space come near in memory. Those of one cell keep their order.
/// @param scale a factor that takes the positions to where differences of any two are finite
/// @param box of scale times the positions
/// @param shift how far below the box the curve's cells begin, in parts of its size: with another
/// shift the curve turns elsewhere
std::vector<Index> spatial_order(std::span<const Vec3> positions, std::span<const Index> chosen,
                                 double scale, const Box& box, double shift, ThreadPool& pool);

}  // namespace planish
