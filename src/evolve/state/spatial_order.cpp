#include "evolve/state/spatial_order.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "core/buffer.h"

namespace planish {

namespace {

constexpr int k_digit_bits = 12, k_digits_of_key = 3;
constexpr std::size_t k_digits = std::size_t{1} << k_digit_bits;
constexpr int k_cell_bits = 12;  // on each axis
/// Puts two zero bits after each of the lowest 12 bits.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 16) & 0xff0000ff;
  bits = (bits | bits << 8) & 0xf00f00f;
  bits = (bits | bits << 4) & 0xc30c30c3;
  return (bits | bits << 2) & 0x249249249;
}

/// A vertex and its cell's place on the curve.
struct Key {
  std::uint64_t cell;
  Index vertex;
};

/// Calls body(part, begin, end) for one part of [0, count) a thread: more would write to the same
/// lines of cache when they sort. What is done here does not depend on how it is cut.
template <class Body>
void for_parts(std::size_t count, ThreadPool& pool, const Body& body) {
  const std::size_t parts = pool.size();
  pool.for_ranges(parts, 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t part = first; part < last; ++part)
      body(part, count * part / parts, count * (part + 1) / parts);
  });
}

/// Sorts by one digit of the cell and keeps the order within.
void sort_by_digit(const Buffer<Key>& keys, Buffer<Key>& sorted, int digit, ThreadPool& pool) {
  const auto digit_of = [shift = digit * k_digit_bits](const Key& key) {
    return key.cell >> shift & (k_digits - 1);
  };
  std::vector<std::array<std::size_t, k_digits>> next(pool.size());
  for_parts(keys.size(), pool, [&](std::size_t part, std::size_t begin, std::size_t end) {
    next[part].fill(0);
    for (std::size_t i = begin; i < end; ++i)
      ++next[part][digit_of(keys[i])];
  });
  std::size_t total = 0;
  for (std::size_t d = 0; d < k_digits; ++d) {
    for (auto& of_part : next)
      total += std::exchange(of_part[d], total);
  }
  for_parts(keys.size(), pool, [&](std::size_t part, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      sorted[next[part][digit_of(keys[i])]++] = keys[i];
  });
}

}  // namespace

Box bounding_box(std::span<const Vec3> positions, std::span<const Index> chosen, ThreadPool& pool) {
  std::vector<Box> boxes(pool.size());
  for_parts(chosen.size(), pool, [&](std::size_t part, std::size_t begin, std::size_t end) {
    Box box;  // put into place at last: threads shall not share a line of cache
    for (std::size_t i = begin; i < end; ++i)
      box.add(positions[chosen[i]]);
    boxes[part] = box;
  });
  Box box;
  for (const Box& part : boxes)
    box.add(part);
  return box;
}

std::vector<Index> spatial_order(std::span<const Vec3> positions, std::span<const Index> chosen,
                                 double scale, const Box& box, double shift, ThreadPool& pool) {
  const std::size_t count = chosen.size();
  const Vec3 size = box.high - box.low;
  const double extent = std::max({size.x, size.y, size.z, 0.0});
  const double cells = extent > 0.0 ? ((1 << k_cell_bits) - 1) / ((1.0 + shift) * extent) : 0.0;
  const Vec3 origin = box.low - shift * Vec3{extent, extent, extent};
  Buffer<Key> keys(count), sorted(count);
  for_parts(count, pool, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Vec3 p = cells * (scale * positions[chosen[i]] - origin);
      keys[i] = {spread(static_cast<std::uint64_t>(p.x)) |
                     spread(static_cast<std::uint64_t>(p.y)) << 1 |
                     spread(static_cast<std::uint64_t>(p.z)) << 2,
                 chosen[i]};
    }
  });
  for (int digit = 0; digit < k_digits_of_key; ++digit) {
    sort_by_digit(keys, sorted, digit, pool);
    std::swap(keys, sorted);
  }
  std::vector<Index> order(count);
  for_parts(count, pool, [&](std::size_t, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      order[i] = keys[i].vertex;
  });
  return order;
}

}  // namespace planish
