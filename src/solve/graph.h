#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// Who is next to whom, as compressed rows: symmetric, no vertex next to itself.
struct Graph {
  std::vector<std::size_t> start = {0};  ///< one more than there are vertices
  std::vector<Index> neighbours;

  std::size_t vertex_count() const { return start.size() - 1; }
  std::span<const Index> of(Index v) const {
    return {neighbours.data() + start[v], start[v + 1] - start[v]};
  }
};

}  // namespace planish
