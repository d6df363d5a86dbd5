#pragma once

#include <span>
#include <vector>

#include "core/thread_pool.h"
#include "energy/angle_jacobian.h"
#include "evolve/auto/shared/descent_limits.h"
#include "evolve/state/patch_state.h"

namespace planish {

/// Inner vertices around large defects, and what their moves change.
struct DefectClusters {
  std::vector<Index> vertices;  ///< those that move, increasing
  std::vector<Index> rows;      ///< inner vertices whose defects depend on them, increasing
  /// Their clusters, numbered from 0: vertices that change a common defect are in one cluster.
  std::vector<Index> cluster_of_vertex, cluster_of_row;
  std::size_t count = 0;
};

/// The clusters around the vertices of the largest defects, as of the last measure().
DefectClusters clusters_of_largest_defects(const PatchState& state, const AngleJacobian& jacobian);

/// Lowers the energy of each of these clusters by itself, in least-norm steps with Levenberg and
/// Marquardt's damping (docs/methods/auto.md). Where the surface is nearly flat, defects go with
/// the squares of moves: the few vertices there need many small steps. A cluster takes a step only
/// if its energy falls and it keeps the limits. The defects are to be measured again afterwards.
/// @param jacobian of the whole patch
/// @param inverse_weights 1/w^2 by inner vertex
void reduce_largest_defects(PatchState& state, const AngleJacobian& jacobian,
                            std::span<const double> inverse_weights, const DescentLimits& limits,
                            ThreadPool& pool);

}  // namespace planish
