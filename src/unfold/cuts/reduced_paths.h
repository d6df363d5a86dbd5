#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>

#include "mesh/cut/cut_paths.h"
#include "mesh/disjoint_sets.h"

namespace planish {

/// Paths of edges.
using Chains = std::vector<std::vector<Index>>;

/// The edges of paths that are not on the border, as chains between places on the border, branches
/// and ends. The longest first.
Chains inner_chains(const Patch& patch, std::span<const std::vector<Index>> paths);

/// Without chains that end inside.
Chains without_loose(const Patch& patch, Chains chains);

/// The regions that chains divide a mesh into.
class Regions {
 public:
  /// @param chains of inner edges
  Regions(const Patch& patch, std::span<const std::vector<Index>> chains);

  /// Those on the sides of a chain, known by a triangle of theirs.
  struct Sides {
    Index left, right;
  };
  Sides sides(std::span<const Index> chain);
  /// Square units of the mesh at its unit scale.
  double area(Index region) const { return areas_[region]; }
  void join(const Sides& sides);
  std::size_t count() const { return count_; }

 private:
  DisjointSets<Index> sets_;
  std::vector<double> areas_;  // by the first triangle of a region
  std::vector<EdgeEnds> edges_;
  std::vector<Sides> beside_;  // triangles of each edge
  std::size_t count_ = 0;
};

/// What is left of paths of edges where no part of them may divide the mesh: of the inner chains
/// that divide it together, the longest are left out. Linear time, but for sorting.
/// @param keep_ends chains may end inside, as those to a tip do; else such are left out too
Chains reduced_paths(const Patch& patch, std::span<const std::vector<Index>> paths, bool keep_ends);

}  // namespace planish
