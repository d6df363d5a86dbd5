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

using Key = std::pair<std::uint64_t, Index>;

/// Sorts pieces side by side and merges them pair by pair; keys differ, so that any way gives the
/// same order.
void sort_keys(std::vector<Key>& keys, ThreadPool& pool) {
  constexpr std::size_t pieces = 8;
  const auto at = [&](std::size_t piece) {
    return keys.begin() + static_cast<std::ptrdiff_t>(keys.size() * piece / pieces);
  };
  pool.for_ranges(pieces, 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      std::sort(at(p), at(p + 1));
  });
  for (std::size_t width = 1; width < pieces; width *= 2) {
    pool.for_ranges(pieces / (2 * width), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t p = 2 * width * begin; p < 2 * width * end; p += 2 * width)
        std::inplace_merge(at(p), at(p + width), at(p + 2 * width));
    });
  }
}

}  // namespace

std::vector<Index> spatial_order(std::span<const Vec3> positions, double scale,
                                 std::span<const Index> chosen, ThreadPool& pool) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Vec3 low{inf, inf, inf}, high{-inf, -inf, -inf};
  for (const Index v : chosen) {
    const Vec3 p = scale * positions[v];
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vec3 size = high - low;
  const double extent = std::max({size.x, size.y, size.z, 0.0});
  const double cells = extent > 0.0 ? 0x1fffff / extent : 0.0;
  std::vector<Key> keys(chosen.size());
  pool.for_ranges(chosen.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 p = cells * (scale * positions[chosen[i]] - low);
      keys[i] = {spread(static_cast<std::uint64_t>(p.x)) |
                     spread(static_cast<std::uint64_t>(p.y)) << 1 |
                     spread(static_cast<std::uint64_t>(p.z)) << 2,
                 chosen[i]};
    }
  });
  sort_keys(keys, pool);
  std::vector<Index> order;
  order.reserve(keys.size());
  for (const auto& key : keys)
    order.push_back(key.second);
  return order;
}

}  // namespace planish
