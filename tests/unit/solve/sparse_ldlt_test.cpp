#include "solve/sparse_ldlt.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include "solve/dissection.h"
#include "solve/front.h"
#include "solve/subtrees.h"

namespace planish {
namespace {

/// On one thread.
bool factored(SparseLdlt& solver, const SparseMatrix& lower) {
  ThreadPool alone(1);
  return solver.factor(lower, alone);
}

using Eigen::MatrixXd;

/// A grid of points, those at most `reach` steps apart in either direction joined.
struct Grid {
  std::vector<Vec3> positions;
  Graph graph;
};

Grid grid(int rows, int columns, int reach) {
  Grid grid;
  for (int i = 0; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      grid.positions.push_back({1.0 * i, 1.0 * j, 0.1 * i * j});
      for (int y = std::max(0, i - reach); y <= std::min(rows - 1, i + reach); ++y) {
        for (int x = std::max(0, j - reach); x <= std::min(columns - 1, j + reach); ++x) {
          if (y != i || x != j)
            grid.graph.neighbours.push_back(static_cast<Index>(y * columns + x));
        }
      }
      grid.graph.start.push_back(grid.graph.neighbours.size());
    }
  }
  return grid;
}

/// The lower half of a symmetric matrix of the pattern with random entries; the diagonal makes it
/// positive definite, or where `sign` says so negative definite.
SparseMatrix random_matrix(const Graph& graph, std::mt19937& random, const auto& sign) {
  std::uniform_real_distribution<double> entry(-1.0, 1.0);
  const auto n = static_cast<int>(graph.vertex_count());
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < n; ++i) {
    const auto next = graph.of(static_cast<Index>(i));
    entries.emplace_back(i, i, sign(i) * (0.5 + static_cast<double>(next.size())));
    for (const Index j : next) {
      if (static_cast<int>(j) < i) entries.emplace_back(i, static_cast<int>(j), entry(random));
    }
  }
  SparseMatrix lower(n, n);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

double residual(const SparseMatrix& lower, const MatrixXd& x, const MatrixXd& right) {
  return (lower.selfadjointView<Eigen::Lower>() * x - right).norm() / right.norm();
}

TEST(SparseLdlt, SolvesDefiniteSystemsOfManySizesAndPatterns) {
  std::mt19937 random(1);
  for (const auto [rows, columns, reach] :
       {std::array{1, 1, 1}, std::array{1, 40, 1}, std::array{7, 9, 1}, std::array{30, 31, 2},
        std::array{60, 45, 1}, std::array{8, 8, 7}}) {
    const Grid g = grid(rows, columns, reach);
    const SparseMatrix a = random_matrix(g.graph, random, [](int) { return 1.0; });
    SparseLdlt solver(a, nested_dissection(g.positions, g.graph));
    ASSERT_TRUE(factored(solver, a));
    const MatrixXd right = MatrixXd::Random(a.rows(), 3);
    EXPECT_LT(residual(a, solver.solve(right), right), 1e-13) << rows << " x " << columns;
  }
}

TEST(SparseLdlt, AgreesWithEigenUnderAnyOrder) {
  std::mt19937 random(2);
  const Grid g = grid(15, 22, 2);
  const SparseMatrix a = random_matrix(g.graph, random, [](int) { return 1.0; });
  const MatrixXd right = MatrixXd::Random(a.rows(), 1);
  const MatrixXd expected = Eigen::SimplicialLDLT<SparseMatrix>(a).solve(right);
  std::vector<Index> order(g.positions.size());
  for (Index i = 0; i < order.size(); ++i)
    order[i] = i;
  for (int turn = 0; turn < 5; ++turn) {
    SparseLdlt solver(a, order);
    ASSERT_TRUE(factored(solver, a));
    EXPECT_LT((solver.solve(right) - expected).norm(), 1e-13 * expected.norm());
    std::shuffle(order.begin(), order.end(), random);
  }
}

/// [H, J^T; J, -C] scattered over a grid.
TEST(SparseLdlt, SolvesQuasiDefiniteSystems) {
  std::mt19937 random(3);
  const Grid g = grid(25, 40, 1);
  const auto sign = [](int i) { return i % 3 == 0 ? -1.0 : 1.0; };
  SparseMatrix a = random_matrix(g.graph, random, sign);
  SparseLdlt solver(a, nested_dissection(g.positions, g.graph));
  ASSERT_TRUE(factored(solver, a));
  const MatrixXd right = MatrixXd::Random(a.rows(), 1);
  EXPECT_LT(residual(a, solver.solve(right), right), 1e-12);
}

TEST(SparseLdlt, FactorsOtherValuesOfThePatternAndGivesTheSameBitsAgain) {
  std::mt19937 random(4);
  const Grid g = grid(20, 20, 2);
  const SparseMatrix a = random_matrix(g.graph, random, [](int) { return 1.0; });
  const SparseMatrix b = random_matrix(g.graph, random, [](int) { return 1.0; });
  const MatrixXd right = MatrixXd::Random(a.rows(), 2);
  SparseLdlt solver(a, nested_dissection(g.positions, g.graph));
  ASSERT_TRUE(factored(solver, a));
  const MatrixXd first = solver.solve(right);
  ASSERT_TRUE(factored(solver, b));
  EXPECT_LT(residual(b, solver.solve(right), right), 1e-13);
  ASSERT_TRUE(factored(solver, a));
  EXPECT_EQ(solver.solve(right), first);
}

TEST(SparseLdlt, GivesTheSameBitsForEveryNumberOfThreads) {
  std::mt19937 random(7);
  const auto sign = [](int i) { return i % 2 == 0 ? 1.0 : -1.0; };
  for (const Grid& g : {grid(3, 4, 1), grid(70, 90, 2)}) {
    const SparseMatrix a = random_matrix(g.graph, random, sign);
    const MatrixXd right = MatrixXd::Random(a.rows(), 2);
    SparseLdlt solver(a, nested_dissection(g.positions, g.graph));
    ASSERT_TRUE(factored(solver, a));
    const MatrixXd alone = solver.solve(right);
    EXPECT_LT(residual(a, alone, right), 1e-12);
    for (const unsigned threads : {1U, 2U, 3U, 8U}) {
      ThreadPool pool(threads);
      ASSERT_TRUE(solver.factor(a, pool));
      EXPECT_EQ(solver.solve(right), alone) << threads;
      EXPECT_EQ(solver.solve(right, pool), alone) << threads;
    }
  }
}

// Two fronts with 400 columns and 1,100 rows below each, and a root.
TEST(SparseLdlt, GivesTheSameBitsForEveryNumberOfThreadsInLargeFronts) {
  constexpr int leaf = 400, root = 1100, size = 2 * leaf + root;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < size; ++j) {
    entries.emplace_back(j, j, size);
    for (int i = j + 1; i < size; ++i) {
      if (j >= leaf || i < leaf || i >= 2 * leaf) entries.emplace_back(i, j, value(random));
    }
  }
  SparseMatrix a(size, size);
  a.setFromTriplets(entries.begin(), entries.end());
  const MatrixXd right = MatrixXd::Random(size, 3);
  SparseLdlt solver(a);
  ASSERT_TRUE(factored(solver, a));
  const MatrixXd alone = solver.solve(right);
  EXPECT_LT(residual(a, alone, right), 1e-12);
  for (const unsigned threads : {2U, 3U, 8U}) {
    ThreadPool pool(threads);
    ASSERT_TRUE(solver.factor(a, pool));
    EXPECT_EQ(solver.solve(right, pool), alone) << threads;
  }
}

TEST(SparseLdlt, SaysWhereAMatrixIsSingular) {
  std::mt19937 random(5);
  const Grid g = grid(10, 10, 1);
  SparseMatrix a = random_matrix(g.graph, random, [](int) { return 1.0; });
  SparseLdlt solver(a, nested_dissection(g.positions, g.graph));
  SparseMatrix zero = a;
  zero.coeffs() *= 0.0;
  EXPECT_FALSE(factored(solver, zero));
  a.coeffRef(50, 50) = std::nan("");
  EXPECT_FALSE(factored(solver, a));
  ThreadPool pool(2);
  EXPECT_FALSE(solver.factor(a, pool));
}

TEST(SparseLdlt, KeepsFactorsOfSurfacesSmall) {
  Grid g = grid(300, 300, 1);
  for (Vec3& position : g.positions)
    position.z = 0.0;
  std::mt19937 random(6);
  const SparseMatrix a = random_matrix(g.graph, random, [](int) { return 1.0; });
  const SparseLdlt nested(a, nested_dissection(g.positions, g.graph));
  // A banded factor would hold 300 numbers a column.
  EXPECT_LT(static_cast<double>(nested.factor_size()), 220.0 * 300.0 * 300.0);
}

/// Numbers a column of the factor of a strip laid out in space.
double factor_per_column(int width, int length, const auto& place) {
  Grid strip = grid(width, length, 1);
  for (int i = 0; i < width; ++i) {
    for (int j = 0; j < length; ++j)
      strip.positions[static_cast<std::size_t>(i * length + j)] = place(1.0 * i, 1.0 * j);
  }
  std::mt19937 random(7);
  const SparseMatrix a = random_matrix(strip.graph, random, [](int) { return 1.0; });
  const SparseLdlt solver(a, nested_dissection(strip.positions, strip.graph));
  return static_cast<double>(solver.factor_size()) / static_cast<double>(a.cols());
}

TEST(SparseLdlt, KeepsFactorsOfStripsSmallHoweverStretched) {
  const double straight = factor_per_column(6, 3000, [](double i, double j) {
    return Vec3{j, i, 0.0};
  });
  // Its triangles so stretched that the side with few vertices is the longer one.
  const double stretched = factor_per_column(6, 3000, [](double i, double j) {
    return Vec3{1e-3 * j, 1e3 * i, 0.0};
  });
  EXPECT_LT(stretched, 1.2 * straight);
  // Wound to a ring as wide as its hole: every plane passes along hundreds of its edges. Planes
  // alone come to 6 times as much as straight.
  const double wound = factor_per_column(6, 3000, [](double i, double j) {
    const double radius = 5.0 + i, angle = 2e-3 * j;
    return Vec3{radius * std::cos(angle), radius * std::sin(angle), 0.0};
  });
  EXPECT_LT(wound, 2.0 * straight);
}

template <class T>
using MatrixOf = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic>;

/// A front that is padded with zeros, from a matrix; and what comes of it.
template <class T>
struct FactoredFront {
  MatrixOf<T> l;     // the columns that were factored
  MatrixOf<T> rest;  // minus what they take from the rest
  Eigen::Vector<T, Eigen::Dynamic> pivots;
  bool sound = false;
};

template <class T>
FactoredFront<T> factor_padded(const MatrixOf<T>& a, Eigen::Index columns, Isa isa,
                               ThreadPool& pool) {
  const auto width = static_cast<std::size_t>(columns);
  const FrontShape<T> shape{width, static_cast<std::size_t>(a.rows()) - width};
  FrontSpace<T> space{FrontBuffer<T>(shape.panel_size()), FrontBuffer<T>(shape.beside_size()),
                      FrontBuffer<T>(shape.beside_size())};
  std::fill_n(space.panel.data(), shape.panel_size(), T{});
  const auto panel_at = [&](Eigen::Index i, Eigen::Index j) -> T& {
    return space.panel.data()[static_cast<std::size_t>(j) * shape.stride() +
                              shape.place(static_cast<std::size_t>(i))];
  };
  for (Eigen::Index j = 0; j < columns; ++j) {
    for (Eigen::Index i = j; i < a.rows(); ++i)
      panel_at(i, j) = a(i, j);
  }
  FrontBuffer<T> rest(shape.rest_size());
  FactoredFront<T> result;
  result.pivots.resize(columns);
  result.sound =
      factor_front(shape, front_kernel_for<T>(isa), space, result.pivots.data(), rest.data(), pool);
  result.l = MatrixOf<T>::Identity(a.rows(), columns);
  const Eigen::Index left = a.rows() - columns;
  result.rest = MatrixOf<T>::Zero(left, left);
  for (Eigen::Index j = 0; j < a.rows() && result.sound; ++j) {
    for (Eigen::Index i = j + 1; i < a.rows(); ++i) {
      if (j < columns) result.l(i, j) = panel_at(i, j);
    }
    for (Eigen::Index i = j; i < a.rows() && j >= columns; ++i) {
      result.rest(i - columns, j - columns) =
          rest.data()[static_cast<std::size_t>(j - columns) * shape.rest_stride() +
                      static_cast<std::size_t>(i - columns)];
    }
  }
  return result;
}

constexpr std::array k_fronts = {std::array{1, 1},    std::array{5, 2},     std::array{8, 8},
                                 std::array{9, 8},    std::array{60, 60},   std::array{65, 64},
                                 std::array{130, 67}, std::array{150, 100}, std::array{700, 300}};

/// Positive and negative definite rows in turn.
MatrixXd quasi_definite(int size) {
  MatrixXd a = MatrixXd::Random(size, size);
  a = MatrixXd(a + a.transpose());
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      if (i % 2 == j % 2) a(i, j) *= 0.01;
    }
    a(i, i) = i % 2 == 0 ? 4.0 + 0.05 * size : -4.0 - 0.05 * size;
  }
  return a;
}

template <class T>
class FactorFront : public testing::Test {};

using FrontNumbers = testing::Types<double, float>;
TYPED_TEST_SUITE(FactorFront, FrontNumbers);

TYPED_TEST(FactorFront, LeavesTheFactorAndWhatItTakesFromTheRest) {
  ThreadPool pool(1);
  constexpr double rounding =
      500.0 * static_cast<double>(std::numeric_limits<TypeParam>::epsilon());
  for (const auto [size, columns] : k_fronts) {
    const MatrixXd a = quasi_definite(size);
    const auto front =
        factor_padded<TypeParam>(a.template cast<TypeParam>(), columns, best_isa(), pool);
    ASSERT_TRUE(front.sound);
    const MatrixXd l = front.l.template cast<double>();
    const MatrixXd product = l * front.pivots.template cast<double>().asDiagonal() * l.transpose();
    EXPECT_LT((a - product).leftCols(columns).norm(), rounding * a.norm()) << size;
    const Eigen::Index rest = size - columns;
    const MatrixXd expected =
        MatrixXd((-product.bottomRightCorner(rest, rest)).triangularView<Eigen::Lower>());
    EXPECT_LE((front.rest.template cast<double>() - expected).norm(), rounding * a.norm()) << size;
  }
}

TYPED_TEST(FactorFront, GivesTheSameBitsOnEveryProcessor) {
  ThreadPool alone(1), three(3);
  for (const auto [size, columns] : k_fronts) {
    const MatrixOf<TypeParam> a = quasi_definite(size).template cast<TypeParam>();
    const auto expected = factor_padded(a, columns, Isa::baseline, alone);
    for (const Isa isa : available_isas()) {
      const auto front = factor_padded(a, columns, isa, three);
      EXPECT_EQ(front.l, expected.l) << to_string(isa) << size;
      EXPECT_EQ(front.rest, expected.rest) << to_string(isa) << size;
      EXPECT_EQ(front.pivots, expected.pivots) << to_string(isa) << size;
    }
  }
}

TEST(SparseLdlt, AgreesWithDenseEigenOnQuasiDefiniteSystems) {
  for (const int size : {1, 2, 7, 40, 163}) {
    const MatrixXd a = quasi_definite(size);
    const SparseMatrix lower = SparseMatrix(a.sparseView()).triangularView<Eigen::Lower>();
    std::vector<Index> order(static_cast<std::size_t>(size));
    for (Index i = 0; i < order.size(); ++i)
      order[i] = static_cast<Index>(order.size()) - 1 - i;
    SparseLdlt solver(lower, order);
    ASSERT_TRUE(factored(solver, lower));
    const MatrixXd right = MatrixXd::Random(size, 3);
    const MatrixXd expected = Eigen::LDLT<MatrixXd>(a).solve(right);
    EXPECT_LT((solver.solve(right) - expected).norm(), 1e-12 * expected.norm()) << size;
  }
}

LowerRows rows_in(const Graph& graph, std::span<const Index> order) {
  std::vector<Index> place(order.size());
  for (Index k = 0; k < order.size(); ++k)
    place[order[k]] = k;
  LowerRows rows;
  for (const Index v : order) {
    const auto begin = static_cast<std::ptrdiff_t>(rows.columns.size());
    for (const Index w : graph.of(v)) {
      if (place[w] < place[v]) rows.columns.push_back(place[w]);
    }
    std::sort(rows.columns.begin() + begin, rows.columns.end());
    rows.start.push_back(rows.columns.size());
  }
  return rows;
}

Supernodes tree_of(const Grid& g) {
  std::vector<Index> order = nested_dissection(g.positions, g.graph);
  const auto later = postorder(elimination_tree(rows_in(g.graph, order)));
  std::vector<Index> sorted;
  for (const Index k : later)
    sorted.push_back(order[k]);
  const LowerRows rows = rows_in(g.graph, sorted);
  return find_supernodes(rows, elimination_tree(rows));
}

TEST(Supernodes, AreATreeThatHoldsEveryColumnOnce) {
  const Grid g = grid(30, 30, 1);
  const Supernodes tree = tree_of(g);
  EXPECT_EQ(tree.first.front(), 0U);
  EXPECT_EQ(tree.first.back(), 900U);
  for (std::size_t s = 0; s < tree.count(); ++s) {
    const auto below = tree.rows(s);
    EXPECT_LT(tree.first[s], tree.first[s + 1]);
    EXPECT_TRUE(std::is_sorted(below.begin(), below.end()));
    if (tree.parent[s] == Supernodes::k_root) {
      EXPECT_TRUE(below.empty());
      continue;
    }
    // What is below a child are columns or rows of its parent.
    const std::size_t up = tree.parent[s];
    EXPECT_GT(up, s);
    for (const Index row : below) {
      const auto rows_up = tree.rows(up);
      EXPECT_TRUE(row < tree.first[up + 1] ||
                  std::binary_search(rows_up.begin(), rows_up.end(), row));
    }
  }
}

TEST(Subtrees, HoldEverySupernodeOnceAndWholeFamilies) {
  const Supernodes tree = tree_of(grid(60, 70, 2));
  constexpr std::size_t top = static_cast<std::size_t>(-1), nowhere = top - 1;
  for (const unsigned threads : {1U, 2U, 5U}) {
    const Subtrees split = split_tree(tree, threads);
    std::vector<std::size_t> part(tree.count(), nowhere);
    const auto place = [&](std::size_t s, std::size_t where) {
      EXPECT_EQ(part[s], nowhere) << s;
      part[s] = where;
    };
    double all = 0.0, most = 0.0;
    for (std::size_t p = 0; p < split.parts.size(); ++p) {
      double work = 0.0;
      for (std::size_t s = split.parts[p].begin; s < split.parts[p].end; ++s) {
        place(s, p);
        work += work_of(tree, s);
      }
      most = std::max(most, work);
      all += work;
    }
    for (const Index s : split.top) {
      place(s, top);
      all += work_of(tree, s);
    }
    EXPECT_LE(most, all / (16.0 * threads));
    EXPECT_TRUE(std::is_sorted(split.top.begin(), split.top.end()));
    for (std::size_t s = 0; s < tree.count(); ++s) {
      EXPECT_NE(part[s], nowhere);
      const Index up = tree.parent[s];
      EXPECT_TRUE(up == Supernodes::k_root || part[up] == part[s] || part[up] == top);
    }
  }
}

/// The stages' shares of the tree, and what they ask for: no child later than its parent.
TEST(Subtrees, ComeInStagesThatLeaveNothingBehind) {
  for (const int width : {3, 60}) {
    const Supernodes tree = tree_of(grid(width, 70, 2));
    const Subtrees split = split_tree(tree, 2);
    std::vector<std::size_t> stage(tree.count());
    std::vector<double> work(split.stages.size(), 0.0);
    Subtrees::Stage done = {};
    for (std::size_t k = 0; k < split.stages.size(); ++k) {
      const auto take = [&](std::size_t s) {
        stage[s] = k;
        work[k] += work_of(tree, s);
      };
      for (; done.parts_end < split.stages[k].parts_end; ++done.parts_end) {
        for (std::size_t s = split.parts[done.parts_end].begin; s < split.parts[done.parts_end].end;
             ++s)
          take(s);
      }
      for (; done.top_end < split.stages[k].top_end; ++done.top_end)
        take(split.top[done.top_end]);
    }
    EXPECT_EQ(done.parts_end, split.parts.size());
    EXPECT_EQ(done.top_end, split.top.size());
    for (std::size_t s = 0; s < tree.count(); ++s) {
      const Index up = tree.parent[s];
      EXPECT_TRUE(up == Supernodes::k_root || stage[s] <= stage[up]) << s;
    }
    if (width < 60) continue;
    EXPECT_GE(work.size(), 3U);
    const double all = std::accumulate(work.begin(), work.end(), 0.0);
    for (std::size_t k = 0; k + 1 < work.size(); ++k)
      EXPECT_LT(work[k], 0.6 * all) << k;
  }
}

TEST(SparseLdlt, MultipliesRowsAndColumnsByTheScale) {
  ThreadPool pool(2);
  const Grid g = grid(30, 20, 1);
  std::mt19937 random(7);
  const SparseMatrix lower = random_matrix(g.graph, random, [](int) { return 1.0; });
  const auto order = nested_dissection(g.positions, g.graph);
  std::vector<double> scale;
  for (Eigen::Index i = 0; i < lower.rows(); ++i)
    scale.push_back(std::ldexp(1.0, static_cast<int>(i % 7) - 3));
  SparseMatrix scaled = lower;
  for (int j = 0; j < scaled.outerSize(); ++j) {
    for (SparseMatrix::InnerIterator entry(scaled, j); entry; ++entry)
      entry.valueRef() *=
          scale[static_cast<std::size_t>(entry.row())] * scale[static_cast<std::size_t>(j)];
  }
  SparseLdlt by_scale(lower, order), by_values(lower, order);
  ASSERT_TRUE(static_cast<BasicLdlt<double>&>(by_scale).factor(lower.valuePtr(), scale, pool));
  ASSERT_TRUE(by_values.factor(scaled, pool));
  const MatrixXd right = MatrixXd::Random(lower.rows(), 1);
  EXPECT_EQ(by_scale.solve(right), by_values.solve(right));
}

TEST(NestedDissection, IsAnOrderOfTheVerticesAskedFor) {
  const Grid g = grid(40, 50, 2);
  std::vector<Index> asked;
  for (Index v = 0; v < g.graph.vertex_count(); v += v % 3 + 1)
    asked.push_back(v);
  auto order = nested_dissection(g.positions, g.graph, asked);
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, asked);
}

TEST(NestedDissection, OrdersPiecesThatEveryPlanePartsBadly) {
  // Random places, so that planes are no help; rows of which every other one is asked for.
  Grid g = grid(40, 50, 1);
  std::mt19937 random(8);
  std::shuffle(g.positions.begin(), g.positions.end(), random);
  std::vector<Index> asked;
  for (Index v = 0; v < g.graph.vertex_count(); ++v) {
    if (v / 50 % 2 == 0) asked.push_back(v);
  }
  auto order = nested_dissection(g.positions, g.graph, asked);
  std::sort(order.begin(), order.end());
  EXPECT_EQ(order, asked);
}

}  // namespace
}  // namespace planish
