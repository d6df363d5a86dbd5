#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <planish/core/vec.h>

#include <Eigen/Core>

#include "core/thread_pool.h"
#include "evolve/state/patch_state.h"
#include "evolve/systems/positions.h"
#include "solve/sparse_ldlt.h"

namespace planish {

/// How fast something diffuses in a triangle, along a direction and across it.
struct Diffusivity {
  Vec3 direction = {};  ///< of length 1, about in the plane of the triangle
  double along = 1.0, across = 1.0;
};

/// An implicit step of the diffusion of positions on the surface as it is now, by linear elements:
///
///     (W^2 M + t K) v = W^2 M v*,   K_ij = sum over triangles A grad phi_i . a grad phi_j
///
/// a the diffusivity in a triangle, M the mixed areas, W weights, t the time, v* the positions
/// asked for. What is held stays.
class DiffusionSystem {
 public:
  using DiffusivityOf = std::function<Diffusivity(const Triangle&)>;

  /// @param movable,weights by inner vertex
  /// @param rate 1 / t, 0 for the end of the diffusion
  DiffusionSystem(const PatchState& state, std::span<const unsigned char> movable,
                  std::span<const double> weights, double rate, const DiffusivityOf& diffusivity,
                  ThreadPool& pool);

  /// False where the system cannot be solved.
  bool solvable() const { return solvable_; }
  /// @param targets by inner vertex; those that are held stay at theirs
  Positions apply(Positions targets, ThreadPool& pool) const;

 private:
  std::vector<Index> movable_;  // vertices, in the order of the unknowns
  std::vector<double> mass_;    // rate w^2 M of each
  Eigen::MatrixXd held_share_;  // of K times what is held
  std::optional<SparseLdlt> solver_;
  bool solvable_ = false;
};

/// How the normals of linear elements turn in a triangle, as principal directions and curvatures:
/// the symmetric part of the gradient of normals given at the corners.
struct TriangleCurvature {
  Vec3 direction;                    ///< of the first principal curvature, of length 1
  double along = 0.0, across = 0.0;  ///< curvature in that direction, and across it
};
TriangleCurvature triangle_curvature(const std::array<Vec3, 3>& corners,
                                     const std::array<Vec3, 3>& normals);

}  // namespace planish
