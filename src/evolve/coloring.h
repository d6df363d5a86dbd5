#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/core/vec.h>

#include "core/thread_pool.h"

namespace planish {

/// The rings of the inner vertices, which are numbered first; higher numbers are border.
struct InnerRings {
  std::span<const std::size_t> start;  ///< one more than inner vertices
  std::span<const Index> vertices;

  std::size_t count() const { return start.size() - 1; }
  std::span<const Index> of(std::size_t v) const {
    return vertices.subspan(start[v], start[v + 1] - start[v]);
  }
};

/// Colours for inner vertices such that two of one colour share no inner vertex in their closed
/// one-rings: then neither sees what the other changes, and they may move at the same time with
/// the result of moving one after the other. Greedy, in the order of the numbers, which should be
/// near in space where they are near; colours are counted from 0 and few (about 14 on ordinary
/// meshes). Time is linear for bounded valence and stays near it around vertices of any valence.
/// The same on any number of threads.
std::vector<Index> distance_two_colors(const InnerRings& rings, ThreadPool& pool);

}  // namespace planish
