#pragma once

#include <span>
#include <vector>

#include "energy/angle_jacobian.h"
#include "evolve/auto/shared/border_motion.h"
#include "evolve/systems/positions.h"
#include "solve/sparse_ldlt.h"

namespace planish {

/// How many inner vertices a patch has for each one of the patches that the balance of C and strain
/// was found on.
double relative_density(const PatchState& state);

/// What it costs to be somewhere else, and not smooth (docs/methods/auto.md):
///
///     C(x) = 1/2 sum a_v |x_v - x0_v|^2 + 1/2 |L x|^2 + 1/2 |B (x - x0)|^2
///
/// in units of the mean edge; x0 where the vertices were at first, L the cotangent Laplacian over
/// the mixed area of a vertex as its share of the mean area: as the patch was when this was made.
/// B, where the border moves, is the second difference along it: moves of the border are to be
/// smooth, its own form may be as it is. Quadratic, with one matrix for x, y and z. Positions are
/// those of the jacobian's columns.
class FairnessEnergy {
 public:
  /// @param closeness a_v of a vertex of weight 1 on a patch of 4,000 inner vertices. On others it
  ///   goes with the square of the density, as |x - x0|^2 goes against |L x|^2.
  /// @param jacobian must outlive it, as must the state
  /// @param bends of the border, if that moves
  FairnessEnergy(const AngleJacobian& jacobian, const PatchState& state, double closeness,
                 std::vector<SecondDifference> bends = {});

  double value(const Positions& x) const;
  /// Zero where the vertex may not move.
  Positions gradient(const Positions& x) const;
  /// The lower half of L^T L + diag(a) + B^T B, on pairs of vertices two edges apart.
  const SparseMatrix& hessian() const { return hessian_; }
  /// Multiplies the weights of proximity of some vertices, from now on.
  void scale_proximity(std::span<const Index> vertices, double factor);
  /// Multiplies the weights of proximity of all vertices.
  void scale_closeness(double factor);

  /// Moves that are as given at some vertices, nearly, and smooth between them: the least
  /// |L u|^2 + |B u|^2 + |u - u_given|^2, zero where vertices may not move and none is given.
  /// @param given whether the move of a vertex is; others of `moves` are not looked at
  Positions spread(std::span<const unsigned char> given, const Positions& moves,
                   ThreadPool& pool) const;

  /// The mean length of an edge, which is the unit here.
  double unit() const { return unit_; }
  /// By column of the jacobian, as it says.
  std::span<const unsigned char> movable() const { return jacobian_.movable(); }
  /// Where the vertices were at first.
  const Positions& origin() const { return origin_; }

 private:
  /// L x, over the mean edge.
  Positions laplacian(const Positions& x) const;
  /// B (x - x0), over the mean edge.
  Positions bends_of(const Positions& x) const;

  const AngleJacobian& jacobian_;
  const PatchState& state_;
  double unit_;
  Positions origin_;
  std::vector<double> pull_;               // a_v
  std::vector<std::vector<double>> rows_;  // of L, at the neighbours
  std::vector<SecondDifference> bends_;    // rows of B
  SparseMatrix hessian_;
};

}  // namespace planish
