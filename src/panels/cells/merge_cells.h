#pragma once

#include <span>
#include <vector>

#include "core/thread_pool.h"
#include "panels/piece/panel_mesh.h"

namespace planish {

/// How cells of a mesh become fewer.
struct MergeOptions {
  double limit = 0.02;  ///< of the strain of each, rms by area
  /// Of the border of the smaller one, two cells share at least this, so that none becomes a comb.
  double least_share = 0.2;
  double on_creases = 1.0;  ///< what a length counts for there in what they share
};

/// Merges cells with neighbours, one pair after the other, as long as the strain of both together
/// (measured_piece()) keeps the limit and they are a disk, perhaps with holes of the mesh. First
/// the pair with the largest share of their border in common, less 0.3 times the square of strain
/// over limit.
/// @param cells of each triangle its cell, from 0
/// @return the same, renumbered
std::vector<Index> merge_cells(const PanelMesh& mesh, std::span<const Index> cells,
                               const MergeOptions& options, ThreadPool& pool);

/// Open edges between cells.
OpenEdges open_between(const PanelMesh& mesh, std::span<const Index> cells);

}  // namespace planish
