#pragma once

#include <array>
#include <cstdint>
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
  /// Where the entries of an edge lie among the Hessian's values, in the order that they are made
  /// in.
  using EdgeSlots = std::array<std::uint32_t, 10>;
  EdgeSlots slots_of(const FlatEdge& edge) const;
  /// Adds a function of the vector from one end of an edge to the other.
  /// @param slots of the edge
  void add(const FlatEdge& edge, const EdgeSlots& slots, Vec2 gradient, const EdgeHessian& hessian);

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
  template <class Visit>
  void for_pairs(const FlatEdge& edge, Visit visit) const;

  const Disk& disk_;
  Unknowns unknowns_;
  SparseMatrix hessian_;
  // Where entries go among its values, in the order that they are made in.
  std::vector<std::size_t> slots_;
  Eigen::VectorXd gradient_;
};

}  // namespace planish
