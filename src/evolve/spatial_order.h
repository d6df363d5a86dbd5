#pragma once

#include <span>
#include <vector>

#include <planish/core/vec.h>

#include "core/thread_pool.h"

namespace planish {

/// The numbers of `chosen` sorted along a space-filling curve (Morton) through scale times their
/// positions: vertices near in space come near in memory. Equal cells keep the order of numbers.
std::vector<Index> spatial_order(std::span<const Vec3> positions, double scale,
                                 std::span<const Index> chosen, ThreadPool& pool);

}  // namespace planish
