#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include <planish/mesh/patch.h>

#include "mesh/cut/inside_paths.h"
#include "mesh/half_edges.h"

namespace planish {

/// Finds loops along edges that go around a limb, a tube or a handle.
class LoopFinder {
 public:
  explicit LoopFinder(const Patch& patch);

  /// Shortest paths from v to all vertices.
  InsidePaths::Tree paths_from(Index v) const;

  /// The shortest loop of two such paths and an edge between their ends that has on either side at
  /// least a fifth of its squared length as area, or does not divide the surface. A hole counts as
  /// the disk with its border for circumference. What both paths have in common at their beginning
  /// is left out.
  /// @return the vertices, the first one again at the end; nothing where there is no such loop
  std::optional<std::vector<Index>> shortest_loop(Index v, const InsidePaths::Tree& paths) const;

 private:
  struct Sides;
  Sides sides(Index v, const InsidePaths::Tree& paths) const;
  Index edge_of(Index half) const { return std::min(half, half_edges_.twin(half)); }
  Index node_beyond(Index half) const;

  Patch patch_;
  HalfEdges half_edges_;
  std::vector<double> area_;                 // of triangles, then of holes; scaled
  std::vector<std::vector<Index>> borders_;  // half-edges of each hole
  std::vector<Index> hole_of_;               // half-edge -> hole, at the border
};

}  // namespace planish
