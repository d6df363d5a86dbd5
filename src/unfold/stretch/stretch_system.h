#pragma once

#include <vector>

#include <Eigen/Core>

#include "solve/sparse_ldlt.h"
#include "unfold/stretch/flat_edges.h"
#include "unfold/stretch/flat_steps.h"

namespace planish {

/// Gradient and Hessian (lower half) of the stretch of a whole flat disk. Terms of edges may be
/// added: they need no further entries.
class StretchSystem {
 public:
  explicit StretchSystem(const Disk& disk);

  /// Sets both to those of the symmetric Dirichlet energy.
  void assemble(const std::vector<Vec2>& flat, Curvature curvature);
  /// Adds a function of the vector from one end of an edge to the other.
  void add(const FlatEdge& edge, Vec2 gradient, const EdgeHessian& hessian);

  bool solved_by(const Eigen::VectorXd& step) const;
  const SparseMatrix& hessian() const { return hessian_; }
  const Eigen::VectorXd& gradient() const { return gradient_; }
  /// Adds to a vector of the unknowns what the ends of an edge get.
  void add_to(Eigen::VectorXd& unknowns, const FlatEdge& edge, Vec2 gradient) const;
  std::vector<Vec2> spread(const Eigen::VectorXd& unknowns) const;

 private:
  void make_pattern();
  template <class Visit>
  void for_pairs(const Triangle& tri, Visit visit) const;

  const Disk& disk_;
  Unknowns unknowns_;
  SparseMatrix hessian_;
  // Where entries go among its values, in the order that they are made in.
  std::vector<std::size_t> slots_;
  Eigen::VectorXd gradient_;
};

}  // namespace planish
