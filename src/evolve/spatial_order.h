#pragma once

#include <span>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// The numbers of `chosen` sorted along a space-filling curve (Morton) through their positions:
/// vertices near in space come near in memory. Equal cells keep their order.
std::vector<Index> spatial_order(std::span<const Vec3> positions, std::span<const Index> chosen);

}  // namespace planish
