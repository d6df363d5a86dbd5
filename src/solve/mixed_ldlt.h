#pragma once

#include <optional>
#include <span>
#include <vector>

#include "solve/sparse_ldlt.h"

namespace planish {

/// In which numbers a matrix is factored: mixed, in float with residuals in double.
enum class Precision { full, mixed };

/// Solves as SparseLdlt does; where mixed, in half of its memory and, where fronts are large, in
/// half of its time: factors in float the matrix whose rows and columns are divided by the roots of
/// its diagonal, which is then the preconditioner of GMRES in double (Carson and Higham 2017). If
/// float cannot factor a matrix, or a dozen solutions with its factor leave much, that matrix is
/// factored in double. Which of the two it is follows from the matrix and the right side alone.
class MixedLdlt {
 public:
  /// @param lower,order,pool as of SparseLdlt
  MixedLdlt(const SparseMatrix& lower, std::span<const Index> order, Precision precision,
            const ThreadPool* pool = {});

  /// Factors a matrix of the pattern. False where that cannot be in double either.
  bool factor(const SparseMatrix& lower, ThreadPool& pool);

  /// x with A x = right.
  /// @param lower that was factored. @pre factor() was true
  /// @param accuracy of the residual, as a share of the right side, both scaled; where all is in
  ///   double it is what it is
  Eigen::VectorXd solve(const SparseMatrix& lower, const Eigen::VectorXd& right, ThreadPool& pool,
                        double accuracy);

  /// Frees the factor, until the next one is made.
  void release();

  /// Whether the last matrix was factored in double, and whether it was to be in float.
  bool is_double() const { return is_double_; }
  bool fell_back() const { return narrow_ && is_double_; }

 private:
  bool factor_in_double(const SparseMatrix& lower, ThreadPool& pool);
  std::optional<Eigen::VectorXd> refined(const SparseMatrix& lower, const Eigen::VectorXd& right,
                                         ThreadPool& pool, double accuracy) const;

  std::vector<Index> order_;
  std::optional<BasicLdlt<float>> narrow_;  // where mixed
  Eigen::VectorXd scale_;                   // powers of two, so that scaling rounds nothing
  std::optional<SparseLdlt> wide_;
  bool is_double_ = false;
  bool is_solvable_ = true;  // what had to be factored in double could be
};

}  // namespace planish
