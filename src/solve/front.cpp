#include "solve/front.h"

#include <algorithm>

namespace planish {

namespace {

constexpr std::size_t k_block = 64;  // columns that are factored before the rest hears of it
static_assert(k_block % k_strip == 0);

/// Calls body(begin, end) for parts of [begin, end) on all threads if that is worth waking them.
void for_strips(ThreadPool& pool, std::size_t begin, std::size_t end, std::size_t work_of_strip,
                const auto& body) {
  constexpr std::size_t enough = 1'000'000;  // multiplications; waking takes some 60 us
  const std::size_t grain = 1 + enough / work_of_strip;
  if (end - begin < 2 * grain) return body(begin, end);
  pool.for_ranges(end - begin, grain,
                  [&](std::size_t from, std::size_t to) { body(begin + from, begin + to); });
}

}  // namespace

std::size_t FrontShape::beside_size() const {
  return stride() * std::min(padded(columns), k_block);
}

bool factor_front(const FrontShape& shape, const FrontKernel& kernel, FrontSpace& space,
                  double* pivots, double* rest, ThreadPool& pool) {
  const std::size_t padded = FrontShape::padded(shape.columns);
  double reciprocals[k_block];
  for (std::size_t k = 0; k < shape.columns; k += k_block) {
    FrontBlock block{};
    block.stride = shape.stride();
    block.front = space.panel.data() + k * block.stride + k;
    block.width = std::min(k_block, shape.columns - k);
    block.padded = FrontShape::padded(block.width);
    block.scaled = space.scaled.data();
    block.packed = space.packed.data();
    block.pivots = pivots + k;
    block.reciprocals = reciprocals;
    if (!kernel.factor_diagonal(block)) return false;
    const std::size_t first = block.padded / k_strip;   // strip below the block
    const std::size_t beyond = (padded - k) / k_strip;  // and below all columns
    const std::size_t end = (block.stride - k) / k_strip;
    if (first == end) break;
    for_strips(pool, first, end, k_strip * block.padded * block.padded / 2,
               [&](std::size_t from, std::size_t to) { kernel.solve_strips(block, from, to); });
    const FrontTarget columns{block.front + block.padded * (block.stride + 1), block.stride, first,
                              beyond, false};
    const FrontTarget below{rest, shape.rest_stride(), beyond, end, k == 0};
    for_strips(pool, first, end, k_strip * block.width * (end - first) * k_strip / 2,
               [&](std::size_t from, std::size_t to) {
                 kernel.update_strips(block, columns, from, to);
                 if (to > beyond) kernel.update_strips(block, below, std::max(from, beyond), to);
               });
  }
  return true;
}

}  // namespace planish
