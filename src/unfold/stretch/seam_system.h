#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "solve/sparse_ldlt.h"
#include "unfold/stretch/border_bend.h"
#include "unfold/stretch/flat_steps.h"

namespace planish {

/// The Newton steps of a flat disk whose border edges are to have given lengths, and whose border
/// bends at a cost (BorderBend):
///
///     [ H  J^T  ] [ move ]   [     -g     ]
///     [ J  -d I ] [ pull ] = [ -gap - d y ]
///
/// g and H gradient and Hessian of both energies plus y times the lengths, J the derivative of the
/// lengths, y the pulls of the edges before, d so small that it only keeps pivots away from 0. A
/// border edge's row comes right after its ends, so that its pivot is far from 0 already. The row
/// of an edge that is free is -1 on the diagonal alone, so that its pull is 0.
class SeamSystem {
 public:
  /// @param lengths of the sides from border[k] to border[k + 1], which must outlive it, as must
  ///   the disk, the bend and the pool
  SeamSystem(const Disk& disk, const BorderLengths& lengths, const BorderBend& bend,
             ThreadPool& pool);

  /// Length less wanted length of each border edge; 0 of those that are free.
  Eigen::VectorXd gaps(const std::vector<Vec2>& flat) const;

  /// Factors at `flat`; false where that cannot be, or where the energy has no minimum among moves
  /// that keep lengths, which happens with full curvature only.
  bool factor(const std::vector<Vec2>& flat, const Eigen::VectorXd& pulls, Curvature curvature);

  struct Step {
    std::vector<Vec2> move;
    Eigen::VectorXd pulls;
    double slope = 0.0;  ///< of the energy along the move
    bool sound = false;  ///< it does solve the system
  };
  /// @pre factor() was true
  Step step(const Eigen::VectorXd& gaps) const;
  /// The least move, in the energy's measure, that changes lengths by as much.
  std::vector<Vec2> correction(const Eigen::VectorXd& change) const;

 private:
  using Matrix6 = Eigen::Matrix<double, 6, 6>;

  void number_unknowns();
  void make_pattern();
  Matrix6 hessian_of(std::size_t t, const std::vector<Vec2>& flat, const Eigen::VectorXd& pulls,
                     Curvature curvature) const;
  void add_lengths(const std::vector<Vec2>& flat);
  void add_gradient(const Triangle& corners, const std::array<double, 6>& gradient);
  std::vector<Vec2> spread(const Eigen::VectorXd& solution) const;
  template <class Visit>
  void for_pairs(const Triangle& tri, Visit visit) const;

  const Disk& disk_;
  ThreadPool& pool_;
  const BorderLengths& lengths_;
  const BorderBend& bend_;
  Unknowns unknowns_;                         // tells what is held; its numbers are not these
  std::vector<int> column_;                   // of x and y of each vertex, k_fixed where held
  std::vector<int> pull_column_;              // of each border edge
  std::vector<std::vector<Index>> edges_of_;  // border edges of each triangle that has some
  SparseMatrix lower_;
  std::vector<std::size_t>
      slots_;  // of the entries of triangles and turns, in the order they are made in
  Eigen::VectorXd gradient_, pulls_;
  std::optional<SparseLdlt> solver_;
};

}  // namespace planish
