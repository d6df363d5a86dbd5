#pragma once

#include <cstddef>
#include <cstdint>

namespace planish {

/// An inner vertex with its closed ring of neighbours, as numbers of places.
struct Star {
  const std::uint32_t* ring;
  std::uint32_t center;
};

/// Where a vertex is and its angle defect, NaN of a border vertex, which has none: what a neighbour
/// needs to see of it, in half a line of cache.
struct alignas(32) Site {
  double x, y, z, defect;
};

}  // namespace planish
