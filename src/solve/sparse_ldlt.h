#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <planish/core/vec.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "core/buffer.h"
#include "core/thread_pool.h"
#include "solve/front.h"
#include "solve/simd/panel_products.h"
#include "solve/subtrees.h"
#include "solve/supernodes.h"

namespace planish {

using SparseMatrix = Eigen::SparseMatrix<double>;

/// Solves sparse symmetric systems whose matrices share one pattern: P A P^T = L D L^T, D diagonal,
/// without pivoting. That exists under any order for definite matrices and for quasi-definite ones,
/// [H, J^T; J, -C] with H and C positive definite (Vanderbei 1995). Multifrontal (Duff and Reid
/// 1983): dense fronts over a tree of supernodes, which a good order keeps small. The factor is
/// made in T and kept in Kept, double or float; solving sums in double.
/// The same bits on every run and for every number of threads: what a front is summed from, and in
/// what order, follows from the pattern alone.
template <class T, class Kept = T>
class BasicLdlt {
 public:
  /// @param lower the lower half of a matrix; values do not matter
  /// @param order the unknowns in order of elimination, as by nested_dissection()
  /// @param pool of the job that the matrix is of
  /// @throws Cancelled
  BasicLdlt(const SparseMatrix& lower, std::span<const Index> order, const ThreadPool* pool = {});
  /// The same for unknowns that are numbered in order of elimination.
  explicit BasicLdlt(const SparseMatrix& lower, const ThreadPool* pool = {});

  /// Factors a matrix of the pattern. False where a pivot or its reciprocal is zero or not finite:
  /// then nothing can be solved.
  /// @param values of its entries, in the order of the first one's
  /// @param scale of each unknown: rows and columns are multiplied by these before they are rounded
  ///   to T; none where it is empty
  bool factor(const double* values, std::span<const double> scale, ThreadPool& pool);

  /// X with A X = right, a column each. @pre factor() was true
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right, ThreadPool& pool) const;
  /// The same on one thread.
  Eigen::MatrixXd solve(const Eigen::MatrixXd& right) const;

  /// How many pivots are negative: by Sylvester's law as many as eigenvalues. @pre factor() was
  /// true
  std::size_t negative_pivots() const {
    return static_cast<std::size_t>((pivots_.array() < T{}).count());
  }

  /// Frees the factor, until the next one is made.
  void release() { panels_ = {}; }

  /// Numbers that the factor takes.
  std::size_t factor_size() const { return panel_start_.back(); }

 private:
  /// Of the columns of L of a supernode what is in its own rows, and what is below.
  TrianglePanel<Kept> triangle(std::size_t node) const;
  Panel<Kept> below(std::size_t node) const;
  /// Where a row of the matrix lies in the front of a supernode.
  Index place_in_front(std::size_t node, Index row) const;
  void link_fronts();
  FrontShape<T> shape_of(std::size_t node) const;
  /// A matrix of the pattern; scale by place.
  struct Matrix {
    const double* values;
    std::vector<double> scale;
  };
  /// For any of these fronts.
  FrontSpace<T> space_for(std::span<const Index> nodes) const;
  void assemble(const Matrix& matrix, std::size_t node, T* panel) const;
  /// @param updates what the supernodes leave to their parents, lower halves; those of its children
  /// are used up
  bool factor_node(const Matrix& matrix, std::size_t node, FrontSpace<T>& space,
                   std::vector<Buffer<T>>& updates, ThreadPool& pool);
  /// @param x in order of elimination: the right side before, the solution after
  void solve_in_place(double* x, ThreadPool& pool) const;
  /// @param left what the rows below each supernode are to be lessened by
  void solve_forward(std::size_t node, double* x, double* left, ThreadPool& pool) const;
  /// @param room for the rows below
  void solve_backward(std::size_t node, double* x, double* room, ThreadPool& pool) const;
  Buffer<double> workspace_below() const;

  Supernodes tree_;
  std::vector<Index> first_child_, sibling_;  // of supernodes, Supernodes::k_root where none
  std::vector<Index> in_parent_;  // for tree_.row_list: where the row lies in the parent's front
  FrontKernel<T> kernel_ = front_kernel_for<T>(best_isa());
  PanelKernel<Kept> panel_kernel_ = panel_kernel_for<Kept>(best_isa());
  std::vector<Index> place_;  // unknown -> when it is eliminated
  // Of each supernode among panels_: its triangle, then what is below.
  std::vector<std::size_t> panel_start_;
  // Where the entries of the matrix go, supernode by supernode.
  struct Entry {
    std::uint32_t place;  // among the front's columns to factor
    std::uint32_t value;  // in the matrix
  };
  std::vector<Entry> entries_;
  std::vector<std::size_t> entry_start_;
  Buffer<Kept> panels_;
  Eigen::Vector<T, Eigen::Dynamic> pivots_;
  Subtrees split_;  // by the pool that factored last; which one never shows in a result
};

/// In double.
class SparseLdlt : public BasicLdlt<double> {
 public:
  using BasicLdlt::BasicLdlt;
  using BasicLdlt::factor;
  bool factor(const SparseMatrix& lower, ThreadPool& pool) {
    return factor(lower.valuePtr(), {}, pool);
  }
};

}  // namespace planish
