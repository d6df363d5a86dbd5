#include "evolve/methods/local_step.h"

#include <vector>

#include <Eigen/Eigenvalues>

namespace planish {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using Rows = std::vector<Eigen::Index>;

/// The shortest solution of the symmetric positive semidefinite system, in least squares.
VectorXd pseudo_solve(const MatrixXd& gram, const VectorXd& side, double rank_threshold) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(gram);
  const VectorXd& values = eigen.eigenvalues();  // ascending
  const double least = rank_threshold * values[values.size() - 1];
  VectorXd shares = eigen.eigenvectors().transpose() * side;
  for (Eigen::Index i = 0; i < values.size(); ++i)
    shares[i] = values[i] > least ? shares[i] / values[i] : 0.0;
  return eigen.eigenvectors() * shares;
}

/// A A^T. Eigen's product would sum in blocks whose sizes depend on those of caches. Most entries
/// of A are zero, as an angle depends on few vertices.
MatrixXd gram_of(const MatrixXd& a) {
  MatrixXd gram = MatrixXd::Zero(a.rows(), a.rows());
  for (Eigen::Index k = 0; k < a.cols(); ++k) {
    for (Eigen::Index j = 0; j < a.rows(); ++j) {
      if (a(j, k) != 0.0) gram.col(j) += a(j, k) * a.col(k);
    }
  }
  return gram;
}

}  // namespace

VectorXd LocalStep::solve(double rank_threshold) const {
  constexpr int k_most_tries = 20;
  constexpr double k_slack = 1e-12;
  // In y = W step all coordinates have equal weight.
  const VectorXd inverse = weights.cwiseInverse();
  const MatrixXd scaled = rows * inverse.asDiagonal();
  const VectorXd start = weights.cwiseProduct(pull);
  const VectorXd missing = scaled * start - sides;  // Lambda B - B_l
  const MatrixXd gram = gram_of(scaled);
  Rows in_force;
  for (Eigen::Index i = 0; i < equations; ++i)
    in_force.push_back(i);
  VectorXd step = pull;
  for (int attempt = 0; attempt < k_most_tries; ++attempt) {
    VectorXd multipliers = VectorXd::Zero(rows.rows());
    if (!in_force.empty())
      multipliers(in_force) =
          pseudo_solve(gram(in_force, in_force), missing(in_force), rank_threshold);
    step = inverse.cwiseProduct(start - scaled.transpose() * multipliers);
    Rows next(in_force.begin(), in_force.begin() + equations);
    for (Eigen::Index i = equations; i < rows.rows(); ++i) {
      const bool pushes = multipliers[i] < 0.0;
      if (pushes || rows.row(i).dot(step) < sides[i] - k_slack) next.push_back(i);
    }
    if (next == in_force) break;
    in_force = std::move(next);
  }
  return step;
}

}  // namespace planish
