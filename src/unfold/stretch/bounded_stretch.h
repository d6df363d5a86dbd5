#pragma once

#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "energy/edge_bounds.h"
#include "unfold/stretch/flat_edges.h"
#include "unfold/stretch/stretch_system.h"

namespace planish {

/// What bounded descent is after.
struct BoundedAims {
  /// All bounds times this need not get smaller. 1: bounds are to be kept; 0: as small as possible.
  double least_scale = 1.0;
  /// What a unit of the scale costs, in units of the energy of the start.
  double weight = 100.0;
  int max_iterations = 200;
};

struct BoundedStretch {
  std::vector<Vec2> flat;
  double scale = 1.0;  ///< every edge keeps its bound times this
  int iterations = 0;
  bool converged = false;
};

/// Minimises the symmetric Dirichlet energy E plus weight * t over flat disks and scales t, subject
/// to -t * bounds[e].shorter <= strain of edge e <= t * bounds[e].longer and t >= least_scale: a
/// primal-dual interior-point method (docs/unfold.md, "Patterns within limits"). Every step keeps
/// the orientation of all triangles.
/// @param system of the disk: what it holds, like lengths of the border, stays held
/// @param bounds one per edge
/// @param start no triangle flipped; best of least stretch
/// @param after_step called after each step; what it throws is passed on
BoundedStretch minimise_stretch_within(const Disk& disk, StretchSystem& system,
                                       std::span<const FlatEdge> edges,
                                       std::span<const EdgeBounds> bounds, std::vector<Vec2> start,
                                       const BoundedAims& aims,
                                       const std::function<void()>& after_step);

}  // namespace planish
