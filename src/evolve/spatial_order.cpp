#include "evolve/spatial_order.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

namespace planish {

namespace {

/// Puts two zero bits after each of the lowest 21 bits.
std::uint64_t spread(std::uint64_t bits) {
  bits &= 0x1fffff;
  bits = (bits | bits << 32) & 0x1f00000000ffff;
  bits = (bits | bits << 16) & 0x1f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  return (bits | bits << 2) & 0x1249249249249249;
}

}  // namespace

std::vector<Index> spatial_order(std::span<const Vec3> positions, std::span<const Index> chosen) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Vec3 low{inf, inf, inf};
  double extent = 0.0;
  for (const Index v : chosen) {
    const Vec3 p = positions[v];
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  }
  for (const Index v : chosen) {
    const Vec3 p = positions[v] - low;
    extent = std::max({extent, p.x, p.y, p.z});
  }
  const double cells = extent > 0.0 ? 0x1fffff / extent : 0.0;
  std::vector<std::pair<std::uint64_t, Index>> keys;
  keys.reserve(chosen.size());
  for (const Index v : chosen) {
    const Vec3 p = cells * (positions[v] - low);
    keys.emplace_back(spread(static_cast<std::uint64_t>(p.x)) |
                          spread(static_cast<std::uint64_t>(p.y)) << 1 |
                          spread(static_cast<std::uint64_t>(p.z)) << 2,
                      v);
  }
  std::sort(keys.begin(), keys.end());
  std::vector<Index> order;
  order.reserve(keys.size());
  for (const auto& key : keys)
    order.push_back(key.second);
  return order;
}

}  // namespace planish
