#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "energy/summand.h"
#include "optimize/block_matrix.h"
#include "solve/sparse_ldlt.h"
#include "unfold/stretch/flat_edges.h"
#include "unfold/stretch/flat_steps.h"

namespace planish {

/// The equations of Newton steps that lower the stretch of a whole flat disk: gradient and Hessian
/// (lower half). Terms of edges may be added: they need no further entries. SeamSystem has those of
/// a disk whose border keeps its lengths.
class StretchSystem {
 public:
  /// @param disk must outlive it, as must the pool
  StretchSystem(const Disk& disk, ThreadPool& pool);
  virtual ~StretchSystem() = default;
  StretchSystem(const StretchSystem&) = delete;
  StretchSystem& operator=(const StretchSystem&) = delete;

  /// Multiplies the weight of bending of a held border, as it was at first, by a factor.
  virtual void stiffen(double /*factor*/) {}
  /// What is to be lowered, without the terms of edges: infinite where a triangle is flipped.
  virtual double energy(const std::vector<Vec2>& flat) const { return total_energy(disk_, flat); }
  /// Sets gradient and Hessian to those of the energy.
  virtual void assemble(const std::vector<Vec2>& flat, Curvature curvature);
  /// The ends of an edge, for add().
  BlockMatrix::Pair pair_of(const FlatEdge& edge) const {
    return matrix_.pair_of(edge.from, edge.to);
  }
  /// Adds a function of the vector from one end of an edge to the other.
  void add(const FlatEdge& edge, BlockMatrix::Pair ends, const EdgeTerm& term);

  const SparseMatrix& hessian() const { return matrix_.lower(); }
  const Eigen::VectorXd& gradient() const { return gradient_; }
  /// False where no step can be solved for.
  virtual bool factor();
  /// By the last factor. @pre factor() was true
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const { return factor_->solve(right, pool_); }
  /// The right side of the step.
  virtual Eigen::VectorXd right() const { return -gradient_; }
  bool solved_by(const Eigen::VectorXd& step) const;

  /// A place near to one that the last factor was made at, with what a step must keep; nothing
  /// where that fails.
  virtual std::optional<std::vector<Vec2>> restored(std::vector<Vec2> flat) const { return flat; }
  /// Called after each step, with the fraction of it that was taken.
  virtual void follow(const Eigen::VectorXd& /*step*/, double /*share*/) {}

  /// Adds to a vector of the unknowns what a vertex gets, or the ends of an edge.
  void add_to(Eigen::VectorXd& unknowns, Index v, Vec2 gradient) const;
  void add_to(Eigen::VectorXd& unknowns, const FlatEdge& edge, Vec2 gradient) const;
  std::vector<Vec2> spread(const Eigen::VectorXd& unknowns) const;

 protected:
  /// With more blocks of one unknown behind those of the vertices.
  /// @param more_pairs of blocks that share no triangle
  StretchSystem(const Disk& disk, std::size_t more_blocks, const BlockMatrix::ForPairs& more_pairs,
                ThreadPool& pool);

  using Hessian6 = std::array<std::array<double, 6>, 6>;
  virtual Hessian6 hessian_of(std::size_t /*t*/, const TriangleEnergy& energy,
                              const std::vector<Vec2>& /*flat*/, Curvature curvature) const {
    return energy.hessian(curvature);
  }
  using TrianglePairs = std::array<BlockMatrix::Pair, 3>;
  TrianglePairs pairs_of(const Triangle& corners) const;
  void add(const Summand<3, Vec2>& part, const TrianglePairs& pairs);
  /// The unknowns in order of elimination; empty where they are numbered so.
  virtual std::vector<Index> elimination_order() const { return {}; }

  const Disk& disk_;
  ThreadPool& pool_;
  BlockMatrix matrix_;  // a block for each vertex, of the coordinates that move
  Eigen::VectorXd gradient_;
  std::optional<SparseLdlt> factor_;

 private:
  std::vector<TrianglePairs> triangle_pairs_;
};

}  // namespace planish
