#pragma once

#include <optional>
#include <span>
#include <vector>

#include "solve/sparse_ldlt.h"

namespace planish {

/// In which numbers a matrix is factored: all in double; in double, the factor rounded to float; or
/// all in float.
enum class Precision { full, rounded, mixed };

/// Solves as SparseLdlt does; but for full precision in half of its memory and, where mixed and
/// fronts are large, in half of its time: factors the matrix whose rows and columns are divided by
/// the roots of its diagonal. Its factor is then the preconditioner of GMRES in double (Carson and
/// Higham 2017). Rounded ones need fewer solutions, of ill-conditioned matrices by far. If float
/// cannot factor a matrix, or a dozen solutions with its factor leave much, that matrix is factored
/// in double. Which of the two it is follows from the matrix and the right side alone.
class MixedLdlt {
 public:
  /// @param lower,order,pool as of SparseLdlt. The upper half may be there too
  MixedLdlt(const SparseMatrix& lower, std::span<const Index> order, Precision precision,
            const ThreadPool* pool = {});

  /// Factors a matrix of the pattern. False where that cannot be in double either.
  bool factor(const SparseMatrix& lower, ThreadPool& pool);

  /// x with A x = right.
  /// @param lower that was factored. @pre factor() was true
  /// @param accuracy of the residual, as a share of the right side, both scaled; where all is in
  ///   double it is what it is
  /// @param enough that a dozen solutions must come to, at least the accuracy. Half is enough for a
  ///   step that a line search judges, and a million vertices leave more than a tenth
  Eigen::VectorXd solve(const SparseMatrix& lower, const Eigen::VectorXd& right, ThreadPool& pool,
                        double accuracy, double enough = 0.5);

  /// Frees the factor, until the next one is made.
  void release();

  /// Whether the factor of the last matrix is in double, and whether it was to be in float.
  bool is_double() const { return is_double_; }
  bool fell_back() const { return is_narrow_ && is_double_; }

 private:
  bool factor_in_float(const SparseMatrix& lower, ThreadPool& pool);
  bool factor_in_double(const SparseMatrix& lower, ThreadPool& pool);
  void release_float();
  std::optional<Eigen::VectorXd> refined(const SparseMatrix& lower, const Eigen::VectorXd& right,
                                         ThreadPool& pool, double accuracy, double enough) const;

  std::vector<Index> order_;
  std::optional<BasicLdlt<float>> mixed_;
  std::optional<BasicLdlt<double, float>> rounded_;
  bool is_narrow_;         // there is one of these
  Eigen::VectorXd scale_;  // powers of two, so that scaling rounds nothing
  std::optional<SparseLdlt> wide_;
  bool is_double_ = false;
  bool is_solvable_ = true;  // what had to be factored in double could be
};

}  // namespace planish
