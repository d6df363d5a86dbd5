#include "solve/mixed_ldlt.h"

#include <cmath>
#include <numeric>
#include <random>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "solve/dissection.h"

namespace planish {
namespace {

using Eigen::VectorXd;

constexpr Precision k_in_float[] = {Precision::mixed, Precision::rounded};

/// The lower half of minus the Laplacian of a grid of n x n points, with `shift` on its diagonal,
/// and an order of elimination.
struct GridSystem {
  SparseMatrix lower;
  std::vector<Index> order;
};

GridSystem grid_system(int n, double shift) {
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<Vec3> places;
  Graph graph;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      const int v = i * n + j;
      double around = 0.0;
      for (const auto& [di, dj] : {std::pair{-1, 0}, {0, -1}, {0, 1}, {1, 0}}) {
        if (i + di < 0 || i + di >= n || j + dj < 0 || j + dj >= n) continue;
        const int w = v + di * n + dj;
        around += 1.0;
        graph.neighbours.push_back(static_cast<Index>(w));
        if (w > v) entries.emplace_back(w, v, -1.0);
      }
      entries.emplace_back(v, v, around + shift);
      places.push_back({1.0 * i, 1.0 * j, 0.0});
      graph.start.push_back(graph.neighbours.size());
    }
  }
  SparseMatrix lower(n * n, n * n);
  lower.setFromTriplets(entries.begin(), entries.end());
  return {lower, nested_dissection(places, graph)};
}

VectorXd random_vector(Eigen::Index size) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  VectorXd vector(size);
  for (double& x : vector)
    x = number(random);
  return vector;
}

double residual(const SparseMatrix& lower, const VectorXd& x, const VectorXd& right) {
  return (lower.selfadjointView<Eigen::Lower>() * x - right).norm() / right.norm();
}

TEST(MixedLdlt, SolvesToTheAccuracyAskedForInFloat) {
  for (const Precision precision : k_in_float) {
    ThreadPool pool(1);
    const GridSystem grid = grid_system(40, 0.1);
    MixedLdlt solver(grid.lower, grid.order, precision);
    ASSERT_TRUE(solver.factor(grid.lower, pool));
    const VectorXd right = random_vector(grid.lower.rows());
    for (const double accuracy : {1e-3, 1e-8, 1e-13})
      EXPECT_LT(residual(grid.lower, solver.solve(grid.lower, right, pool, accuracy), right),
                accuracy);
    EXPECT_GT(residual(grid.lower, solver.solve(grid.lower, right, pool, 1e-3), right), 1e-12);
    EXPECT_FALSE(solver.is_double());
  }
}

TEST(MixedLdlt, SolvesQuasiDefiniteSystems) {
  for (const Precision precision : k_in_float) {
    ThreadPool pool(1);
    GridSystem grid = grid_system(30, 6.0);
    for (int j = 0; j < grid.lower.outerSize(); j += 3)
      grid.lower.coeffRef(j, j) = -7.0;
    MixedLdlt solver(grid.lower, grid.order, precision);
    ASSERT_TRUE(solver.factor(grid.lower, pool));
    const VectorXd right = random_vector(grid.lower.rows());
    EXPECT_LT(residual(grid.lower, solver.solve(grid.lower, right, pool, 1e-12), right), 1e-12);
    EXPECT_FALSE(solver.is_double());
  }
}

/// Numbers beyond the range of a float, and diagonals from 1e-30 to 1e30.
TEST(MixedLdlt, DoesNotMindUnits) {
  for (const Precision precision : k_in_float) {
    ThreadPool pool(1);
    const GridSystem grid = grid_system(20, 0.5);
    SparseMatrix lower = grid.lower;
    const auto unit = [](Eigen::Index i) {
      return std::pow(10.0, static_cast<double>(i % 61 - 30));
    };
    for (int j = 0; j < lower.outerSize(); ++j) {
      for (SparseMatrix::InnerIterator entry(lower, j); entry; ++entry)
        entry.valueRef() *= unit(entry.row()) * unit(j);
    }
    MixedLdlt solver(lower, grid.order, precision);
    ASSERT_TRUE(solver.factor(lower, pool));
    VectorXd right = random_vector(lower.rows());
    VectorXd scaled = right;
    for (Eigen::Index i = 0; i < right.size(); ++i)
      scaled[i] *= unit(i);
    VectorXd x = solver.solve(lower, scaled, pool, 1e-10);
    for (Eigen::Index i = 0; i < right.size(); ++i)
      x[i] *= unit(i);
    EXPECT_LT(residual(grid.lower, x, right), 1e-9);
    EXPECT_FALSE(solver.is_double());
  }
}

/// The square of the Laplacian of a chain: of its small eigenvalues some forty drown in the
/// rounding of floats.
SparseMatrix squared_chain(int size, double shift) {
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < size; ++i) {
    entries.emplace_back(i, i, 6.0 + shift);
    if (i + 1 < size) entries.emplace_back(i + 1, i, -4.0);
    if (i + 2 < size) entries.emplace_back(i + 2, i, 1.0);
  }
  SparseMatrix lower(size, size);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

/// So long that its factor in float takes more than a dozen solutions, its rounded factor fewer.
constexpr int k_medium_chain = 2000;

TEST(MixedLdlt, FactorsInDoubleWhereFloatDoesNotDo) {
  ThreadPool pool(1);
  constexpr int size = 4000;
  const SparseMatrix lower = squared_chain(size, 0.0), better = squared_chain(size, 0.1);
  std::vector<Index> order(size);
  std::iota(order.begin(), order.end(), Index{0});
  MixedLdlt solver(lower, order, Precision::mixed);
  ASSERT_TRUE(solver.factor(lower, pool));
  const VectorXd right = VectorXd::Ones(size);
  EXPECT_LT(residual(lower, solver.solve(lower, right, pool, 1e-3), right), 1e-3);
  EXPECT_TRUE(solver.is_double());
  // A better matrix of the pattern is factored in float again.
  ASSERT_TRUE(solver.factor(better, pool));
  EXPECT_LT(residual(better, solver.solve(better, right, pool, 1e-3), right), 1e-3);
  EXPECT_FALSE(solver.is_double());
}

TEST(MixedLdlt, FactorsInDoubleWhereWhatIsLeftIsNotEnough) {
  ThreadPool pool(1);
  const SparseMatrix lower = squared_chain(k_medium_chain, 0.0);
  std::vector<Index> order(k_medium_chain);
  std::iota(order.begin(), order.end(), Index{0});
  MixedLdlt mixed(lower, order, Precision::mixed), rounded(lower, order, Precision::rounded);
  ASSERT_TRUE(mixed.factor(lower, pool));
  ASSERT_TRUE(rounded.factor(lower, pool));
  const VectorXd right = random_vector(k_medium_chain);
  for (MixedLdlt* solver : {&mixed, &rounded})
    EXPECT_LT(residual(lower, solver->solve(lower, right, pool, 1e-8, 1e-8), right), 1e-6);
  EXPECT_TRUE(mixed.is_double());
  EXPECT_FALSE(rounded.is_double());
}

TEST(MixedLdlt, SolvesIllConditionedSystemsInAFewSteps) {
  for (const Precision precision : k_in_float) {
    ThreadPool pool(1);
    const GridSystem grid = grid_system(40, 1e-9);
    MixedLdlt solver(grid.lower, grid.order, precision);
    ASSERT_TRUE(solver.factor(grid.lower, pool));
    const VectorXd right = VectorXd::Ones(grid.lower.rows());
    EXPECT_LT(residual(grid.lower, solver.solve(grid.lower, right, pool, 1e-6), right), 1e-5);
    EXPECT_FALSE(solver.is_double());
  }
}

TEST(MixedLdlt, IsTheFactorInDoubleWhereThatIsAskedFor) {
  ThreadPool pool(1);
  const GridSystem grid = grid_system(20, 0.1);
  MixedLdlt solver(grid.lower, grid.order, Precision::full);
  SparseLdlt expected(grid.lower, grid.order);
  ASSERT_TRUE(solver.factor(grid.lower, pool));
  ASSERT_TRUE(expected.factor(grid.lower, pool));
  const VectorXd right = random_vector(grid.lower.rows());
  EXPECT_EQ(solver.solve(grid.lower, right, pool, 1e-3), expected.solve(right).col(0));
  EXPECT_TRUE(solver.is_double());
}

TEST(MixedLdlt, SaysWhereAMatrixIsSingular) {
  for (const Precision precision : k_in_float) {
    ThreadPool pool(1);
    GridSystem grid = grid_system(6, 0.5);
    for (int j = 0; j < grid.lower.outerSize(); ++j) {
      for (SparseMatrix::InnerIterator entry(grid.lower, j); entry; ++entry) {
        if (entry.row() == 7 || entry.col() == 7) entry.valueRef() = 0.0;
      }
    }
    MixedLdlt solver(grid.lower, grid.order, precision);
    EXPECT_FALSE(solver.factor(grid.lower, pool));
  }
}

TEST(MixedLdlt, GivesTheSameBitsForEveryNumberOfThreads) {
  for (const Precision precision : k_in_float) {
    ThreadPool alone(1), three(3);
    const GridSystem grid = grid_system(60, 0.01);
    const VectorXd right = random_vector(grid.lower.rows());
    MixedLdlt first(grid.lower, grid.order, precision), again(grid.lower, grid.order, precision);
    ASSERT_TRUE(first.factor(grid.lower, alone));
    ASSERT_TRUE(again.factor(grid.lower, three));
    EXPECT_EQ(first.solve(grid.lower, right, alone, 1e-6),
              again.solve(grid.lower, right, three, 1e-6));
  }
}

}  // namespace
}  // namespace planish
