#pragma once

#include <optional>
#include <span>
#include <vector>

#include <planish/core/vec.h>

#include <Eigen/Core>

#include "core/thread_pool.h"
#include "evolve/state/patch_state.h"
#include "solve/sparse_ldlt.h"

namespace planish {

enum class LaplacianWeights {
  uniform,    ///< the umbrella vector
  cotangent,  ///< cotangents, divided by the area of the vertex over the mean area, so without unit
  thin_plate,  ///< by the root of that: sums of squares are integrals, whatever the triangles
};

/// The positions v of the movable vertices that make sum |L v|^2 + sum (w |v - v*|)^2 smallest, v*
/// the positions asked for, L a Laplacian with a row for each inner vertex. L is that of the patch
/// as it is when this is made, and so is the factor: (L^T L + W^2) v = W^2 v* - L^T g, g the share
/// in L v of vertices that are held.
class FairingSystem {
 public:
  /// @param movable,weights by inner vertex
  FairingSystem(const PatchState& state, std::span<const unsigned char> movable,
                LaplacianWeights kind, std::span<const double> weights, ThreadPool& pool);

  /// False where the system cannot be solved.
  bool solvable() const { return solvable_; }
  /// @param targets by inner vertex; those that are held stay at theirs
  std::vector<Vec3> apply(std::vector<Vec3> targets, ThreadPool& pool) const;

 private:
  std::vector<Index> movable_;  // vertices, in the order of the unknowns
  std::vector<double> pull_;    // w^2 of each
  Eigen::MatrixXd held_share_;  // L^T g
  std::optional<SparseLdlt> solver_;
  bool solvable_ = false;
};

/// The weights of each inner vertex's edges to its ring, as the patch is now; the row of L is their
/// sum at the vertex and minus each at its neighbour.
std::vector<std::vector<double>> rows_of_laplacian(const PatchState& state, LaplacianWeights kind);

}  // namespace planish
