#include "evolve/methods/local_step.h"

#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

constexpr double k_threshold = 1e-10;

using Eigen::MatrixXd;
using Eigen::VectorXd;

MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, meshes::Random& random) {
  return MatrixXd::NullaryExpr(rows, columns, [&] { return random.number(); });
}

LocalStep random_step(Eigen::Index equations, Eigen::Index inequalities, Eigen::Index coordinates,
                      meshes::Random& random) {
  LocalStep step;
  step.rows = random_matrix(equations + inequalities, coordinates, random);
  step.sides = random_matrix(equations + inequalities, 1, random);
  step.equations = equations;
  step.pull = random_matrix(coordinates, 1, random);
  step.weights = random_matrix(coordinates, 1, random).array().exp();
  return step;
}

/// The whole system of Karush, Kuhn and Tucker with some rows as equations: the step, then the
/// multipliers.
VectorXd kkt(const LocalStep& step, const std::vector<Eigen::Index>& in_force) {
  const Eigen::Index n = step.pull.size(), m = static_cast<Eigen::Index>(in_force.size());
  const VectorXd squares = step.weights.cwiseAbs2();
  MatrixXd system = MatrixXd::Zero(n + m, n + m);
  system.topLeftCorner(n, n) = squares.asDiagonal();
  system.bottomLeftCorner(m, n) = step.rows(in_force, Eigen::all);
  system.topRightCorner(n, m) = system.bottomLeftCorner(m, n).transpose();
  VectorXd side(n + m);
  side << squares.cwiseProduct(step.pull), step.sides(in_force);
  return system.fullPivLu().solve(side);
}

double cost(const LocalStep& step, const VectorXd& x) {
  return 0.5 * step.weights.cwiseProduct(x - step.pull).squaredNorm();
}

TEST(LocalStep, SolvesTheWholeKktSystem) {
  meshes::Random random(1);
  for (int round = 0; round < 50; ++round) {
    const LocalStep step = random_step(8, 0, 21, random);
    std::vector<Eigen::Index> all(8);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_LT((step.solve(k_threshold) - kkt(step, all).head(21)).norm(), 1e-9);
  }
}

TEST(LocalStep, MeetsContradictionsInLeastSquares) {
  // Rows that sum to zero, as those of angle sums do, and one that is nothing.
  meshes::Random random(2);
  for (int round = 0; round < 50; ++round) {
    LocalStep step = random_step(9, 0, 24, random);
    step.rows.row(3).setZero();
    step.rows.row(8) = -step.rows.topRows(8).colwise().sum();
    const MatrixXd scaled = step.rows * step.weights.cwiseInverse().asDiagonal();
    const VectorXd start = step.weights.cwiseProduct(step.pull);
    Eigen::JacobiSVD<MatrixXd> svd(scaled, Eigen::ComputeThinU | Eigen::ComputeThinV);
    svd.setThreshold(1e-9);
    EXPECT_EQ(svd.rank(), 7);
    const VectorXd expected =
        (start + svd.solve(step.sides - scaled * start)).cwiseQuotient(step.weights);
    EXPECT_LT((step.solve(k_threshold) - expected).norm(), 1e-9);
  }
}

TEST(LocalStep, LeavesOutWhatIsNearlyContradicted) {
  // A row that differs from another one by a thousandth: singular values of 1.4 and 7e-4.
  LocalStep step;
  step.rows = MatrixXd{{1.0, 0.0}, {1.0, 1e-3}};
  step.sides = VectorXd{{1.0, 2.0}};
  step.equations = 2;
  step.pull = VectorXd::Zero(2);
  step.weights = VectorXd::Ones(2);
  const VectorXd solved = step.solve(1e-5);
  EXPECT_NEAR(solved[0], 1.5, 1e-2);  // exact equations would ask for 1 and 1000
  EXPECT_LT(std::abs(solved[1]), 1e-2);
  EXPECT_NEAR(step.solve(1e-8)[1], 1000.0, 1e-3);
}

TEST(LocalStep, FindsTheBestOfAllActiveSets) {
  meshes::Random random(3);
  int bound = 0;
  for (int round = 0; round < 100; ++round) {
    constexpr Eigen::Index equations = 4, inequalities = 5, coordinates = 15;
    const LocalStep step = random_step(equations, inequalities, coordinates, random);
    double least = std::numeric_limits<double>::infinity();
    VectorXd best;
    for (int set = 0; set < 1 << inequalities; ++set) {
      std::vector<Eigen::Index> in_force;
      for (Eigen::Index i = 0; i < equations + inequalities; ++i) {
        if (i < equations || (set >> (i - equations)) % 2 == 1) in_force.push_back(i);
      }
      const VectorXd x = kkt(step, in_force).head(coordinates);
      const VectorXd over = (step.rows * x - step.sides).tail(inequalities);
      if (over.minCoeff() < -1e-9 || cost(step, x) >= least) continue;
      least = cost(step, x);
      best = x;
      bound += set != 0 && set != (1 << inequalities) - 1;
    }
    EXPECT_LT((step.solve(k_threshold) - best).norm(), 1e-8) << "round " << round;
  }
  EXPECT_GT(bound, 50);
}

TEST(LocalStep, MovesTheDearLess) {
  LocalStep step;
  step.rows = MatrixXd{{1.0, 1.0}};
  step.sides = VectorXd{{1.0}};
  step.equations = 1;
  step.pull = VectorXd::Zero(2);
  step.weights = VectorXd{{1.0, 3.0}};
  EXPECT_NEAR(step.solve(k_threshold)[0], 0.9, 1e-12);
  EXPECT_NEAR(step.solve(k_threshold)[1], 0.1, 1e-12);
}

TEST(LocalStep, WithNothingAskedFollowsThePull) {
  LocalStep step;
  step.rows = MatrixXd::Zero(2, 3);
  step.sides = VectorXd::Ones(2);
  step.equations = 2;
  step.pull = VectorXd{{1.0, -2.0, 3.0}};
  step.weights = VectorXd::Ones(3);
  EXPECT_EQ(step.solve(k_threshold), step.pull);
}

}  // namespace
}  // namespace planish
