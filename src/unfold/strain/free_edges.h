#pragma once

#include <array>
#include <span>
#include <vector>

#include <planish/core/vec.h>

namespace planish {

/// An edge by the vertices at its ends, the lower number first.
std::array<Index, 2> lower_first(Index v, Index w);

/// A set of edges by the vertices at their ends, in either order (UnfoldOptions::free_edges).
class FreeEdges {
 public:
  explicit FreeEdges(std::span<const std::array<Index, 2>> edges);

  bool has(Index v, Index w) const;

 private:
  std::vector<std::array<Index, 2>> sorted_;  // each with the lower number first
};

/// The edges by the vertices that are left, of which source has the earlier numbers, increasing.
/// @pre no end of an edge is gone
std::vector<std::array<Index, 2>> renumbered_edges(std::span<const std::array<Index, 2>> edges,
                                                   std::span<const Index> source);

}  // namespace planish
