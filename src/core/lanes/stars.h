#pragma once

#include <cstddef>
#include <cstdint>

namespace planish {

/// An inner vertex with its closed ring of neighbours, as numbers of places.
struct Star {
  const std::uint32_t* ring;
  std::uint32_t center;
};

/// Places in memory: that of number i is scale times the three doubles at first + i * stride.
struct Places {
  const double* first;
  std::size_t stride;  // in doubles
  double scale;
};

}  // namespace planish
