#include "solve/front.h"

#include <algorithm>

namespace planish {

namespace {

constexpr std::size_t k_block = 64;  // columns that are factored before the rest is updated
static_assert(k_block % k_strip<double> == 0 && k_block % k_strip<float> == 0);

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

template <class T>
std::size_t FrontShape<T>::beside_size() const {
  return stride() * std::min(padded(columns), k_block);
}

template <class T>
bool factor_front(const FrontShape<T>& shape, const FrontKernel<T>& kernel, FrontSpace<T>& space,
                  T* pivots, T* rest, ThreadPool& pool) {
  const std::size_t padded = FrontShape<T>::padded(shape.columns);
  T reciprocals[k_block];
  for (std::size_t k = 0; k < shape.columns; k += k_block) {
    FrontBlock<T> block{};
    block.stride = shape.stride();
    block.front = space.panel.data() + k * block.stride + k;
    block.width = std::min(k_block, shape.columns - k);
    block.padded = FrontShape<T>::padded(block.width);
    block.scaled = space.scaled.data();
    block.packed = space.packed.data();
    block.pivots = pivots + k;
    block.reciprocals = reciprocals;
    if (!kernel.factor_diagonal(block)) return false;
    const std::size_t first = block.padded / k_strip<T>;   // strip below the block
    const std::size_t beyond = (padded - k) / k_strip<T>;  // and below all columns
    const std::size_t end = (block.stride - k) / k_strip<T>;
    if (first == end) break;
    for_strips(pool, first, end, k_strip<T> * block.padded * block.padded / 2,
               [&](std::size_t from, std::size_t to) { kernel.solve_strips(block, from, to); });
    const FrontTarget<T> columns{block.front + block.padded * (block.stride + 1), block.stride,
                                 first, beyond, false};
    const FrontTarget<T> below{rest, shape.rest_stride(), beyond, end, k == 0};
    for_strips(pool, first, end, k_strip<T> * block.width * (end - first) * k_strip<T> / 2,
               [&](std::size_t from, std::size_t to) {
                 kernel.update_strips(block, columns, from, to);
                 if (to > beyond) kernel.update_strips(block, below, std::max(from, beyond), to);
               });
  }
  return true;
}

template struct FrontShape<double>;
template struct FrontShape<float>;
template bool factor_front(const FrontShape<double>&, const FrontKernel<double>&,
                           FrontSpace<double>&, double*, double*, ThreadPool&);
template bool factor_front(const FrontShape<float>&, const FrontKernel<float>&, FrontSpace<float>&,
                           float*, float*, ThreadPool&);

}  // namespace planish
