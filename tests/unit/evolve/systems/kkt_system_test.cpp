#include "evolve/systems/kkt_system.h"

#include <algorithm>

#include <planish/mesh/shapes.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "evolve/systems/dual_system.h"

namespace planish {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A patch laid out, with its Jacobian, sparse and dense.
struct PatchWithJacobian {
  explicit PatchWithJacobian(const Constraints& constraints = {})
      : mesh(make_shape("panel", 150)),
        surface(mesh),
        state(surface, pool, constraints),
        jacobian(angle_jacobian_of(state)) {
    jacobian.update(state.positions(), pool);
    const auto n = static_cast<Eigen::Index>(state.inner_count());
    dense = MatrixXd::Zero(n, 3 * n);
    for (Index v = 0; v < state.inner_count(); ++v) {
      for (const AngleJacobian::Entry& entry : jacobian.column(v)) {
        const Vec3 g = jacobian.gradient(entry.entry);
        dense.block(entry.row, 3 * v, 1, 3) = Eigen::RowVector3d(g.x, g.y, g.z);
      }
    }
  }
  static VectorXd flat(const Positions& positions) {
    VectorXd all(static_cast<Eigen::Index>(3 * positions.size()));
    for (std::size_t v = 0; v < positions.size(); ++v)
      all.segment<3>(static_cast<Eigen::Index>(3 * v)) << positions[v].x, positions[v].y,
          positions[v].z;
    return all;
  }

  TriMesh mesh;
  Patch surface;
  ThreadPool pool{1};
  PatchState state;
  AngleJacobian jacobian;
  MatrixXd dense;
};

/// Each inner vertex tied to its inner neighbours.
SparseMatrix spring_matrix(const PatchState& state) {
  const auto rings = rings_by_vertex(state.plan());
  std::vector<Eigen::Triplet<double>> entries;
  for (int v = 0; v < static_cast<int>(rings.size()); ++v) {
    entries.emplace_back(v, v, 1.5 + static_cast<double>(rings[v].size()));
    for (const Index w : rings[v]) {
      if (state.is_inner(w) && static_cast<int>(w) > v)
        entries.emplace_back(static_cast<int>(w), v, -1.0);
    }
  }
  const auto n = static_cast<int>(rings.size());
  SparseMatrix lower(n, n);
  lower.setFromTriplets(entries.begin(), entries.end());
  return lower;
}

Positions some_forces(std::size_t count) {
  Positions forces(count);
  for (std::size_t v = 0; v < count; ++v)
    forces[v] = {std::sin(1.0 * static_cast<double>(v)), 0.1,
                 std::cos(3.0 * static_cast<double>(v))};
  return forces;
}

TEST(KktSystem, SolvesScalarTermsAsTheDenseMatrixDoes) {
  PatchWithJacobian patch;
  const auto n = static_cast<Eigen::Index>(patch.state.inner_count());
  const SparseMatrix hessian = spring_matrix(patch.state);
  SparseMatrix identity(n, n);
  identity.setIdentity();
  const auto for_entries = [&](const auto& visit) {
    for (int j = 0; j < hessian.outerSize(); ++j) {
      for (SparseMatrix::InnerIterator entry(hessian, j); entry; ++entry)
        visit(static_cast<Index>(entry.row()), static_cast<Index>(j), entry.value());
    }
  };
  const auto for_pairs = [&](const BlockMatrix::VisitPair& visit) {
    for_entries([&](Index v, Index w, double) { visit(v, w); });
  };
  KktSystem system(patch.jacobian, patch.state, for_pairs, identity, {}, Precision::full,
                   patch.pool);
  constexpr double c = 1e-4, scale = 2.0;
  system.clear();
  for_entries([&](Index v, Index w, double value) {
    std::vector<BlockMatrix::Pair> pair;
    system.append_pairs(std::array{v, w}, pair);
    system.add_scalar(v, w, pair.front(), scale, value);
  });
  ASSERT_TRUE(system.factor(identity, c, patch.pool));
  const Positions forces = some_forces(patch.state.inner_count());
  const VectorXd turn = VectorXd::LinSpaced(n, -0.1, 0.2);
  const VectorXd move = PatchWithJacobian::flat(system.solve(forces, turn, patch.pool));

  const MatrixXd h = MatrixXd(hessian).selfadjointView<Eigen::Lower>();
  MatrixXd kkt = MatrixXd::Zero(4 * n, 4 * n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j)
      kkt.block<3, 3>(3 * i, 3 * j) = scale * h(i, j) * Eigen::Matrix3d::Identity();
  }
  kkt.bottomLeftCorner(n, 3 * n) = -patch.dense;
  kkt.topRightCorner(3 * n, n) = -patch.dense.transpose();
  kkt.bottomRightCorner(n, n).diagonal().setConstant(-c);
  VectorXd right(4 * n);
  right << PatchWithJacobian::flat(forces), turn;
  const VectorXd expected = kkt.fullPivLu().solve(right).head(3 * n);
  EXPECT_LT((move - expected).norm(), 1e-9 * expected.norm());
}

TEST(DualSystem, SolvesWhatADenseSolverSolves) {
  PatchWithJacobian patch;
  const auto n = static_cast<Eigen::Index>(patch.state.inner_count());
  std::vector<double> inverse_weights;
  VectorXd s(3 * n);
  for (Eigen::Index v = 0; v < n; ++v) {
    inverse_weights.push_back(0.5 + 0.01 * static_cast<double>(v));
    s.segment<3>(3 * v).setConstant(inverse_weights.back());
  }
  DualSystem system(patch.jacobian, patch.state);
  for (const double mu : {1e-3, 1.0}) {
    ASSERT_TRUE(system.factor(inverse_weights, mu, patch.pool));
    const VectorXd right = VectorXd::LinSpaced(n, 1.0, -2.0);
    MatrixXd dense = patch.dense * s.asDiagonal() * patch.dense.transpose();
    VectorXd sorted = dense.diagonal();
    std::sort(sorted.data(), sorted.data() + n);
    dense.diagonal().array() += mu * sorted[n / 2];
    const VectorXd expected = dense.ldlt().solve(right);
    EXPECT_LT((system.solve(right, patch.pool) - expected).norm(), 1e-10 * expected.norm()) << mu;
  }
}

TEST(DualSystem, IsDampedByWhatItIsTold) {
  PatchWithJacobian patch;
  const auto n = static_cast<Eigen::Index>(patch.state.inner_count());
  const std::vector<double> inverse_weights(patch.state.inner_count(), 1.0);
  // Rows 0 and n - 1 do not meet: what is between them goes to the diagonal.
  SparseMatrix damping(n, n);
  for (int v = 0; v < n; ++v)
    damping.insert(v, v) = 2.0 + 0.1 * (v % 5);
  MatrixXd dense_damping = MatrixXd(damping);
  damping.insert(0, n - 1) = damping.insert(n - 1, 0) = -0.5;
  dense_damping(0, 0) += 0.5;
  dense_damping(n - 1, n - 1) += 0.5;
  VectorXd sorted = VectorXd(damping.diagonal());
  std::sort(sorted.data(), sorted.data() + n);
  dense_damping /= sorted[n / 2];
  dense_damping.diagonal().array() += 0.25;

  MatrixXd dense = patch.dense * patch.dense.transpose();
  ASSERT_EQ(dense(0, n - 1), 0.0);
  sorted = dense.diagonal();
  std::sort(sorted.data(), sorted.data() + n);
  constexpr double mu = 0.1;
  dense += mu * sorted[n / 2] * dense_damping;

  DualSystem system(patch.jacobian, patch.state);
  system.damp_by(damping, 0.25);
  ASSERT_TRUE(system.factor(inverse_weights, mu, patch.pool));
  const VectorXd right = VectorXd::LinSpaced(n, 1.0, -2.0);
  const VectorXd expected = dense.ldlt().solve(right);
  EXPECT_LT((system.solve(right, patch.pool) - expected).norm(), 1e-10 * expected.norm());
}

TEST(AngleJacobian, MultipliesAsItsDenseTwin) {
  PatchWithJacobian patch;
  const Positions moves = some_forces(patch.state.inner_count());
  const VectorXd product = patch.dense * PatchWithJacobian::flat(moves);
  EXPECT_LT((patch.jacobian.times(moves) - product).norm(), 1e-13 * product.norm());
  const VectorXd y = VectorXd::LinSpaced(product.size(), 1.0, 3.0);
  const VectorXd transposed = patch.dense.transpose() * y;
  EXPECT_LT(
      (PatchWithJacobian::flat(patch.jacobian.transposed_times(y, patch.pool)) - transposed).norm(),
      1e-13 * transposed.norm());
}

TEST(AngleJacobian, IsTheDerivativeOfTheAngleSums) {
  PatchWithJacobian patch;
  const Positions directions = some_forces(patch.state.inner_count());
  const Positions start = inner_positions(patch.state);
  const auto defects_at = [&](double t) {
    set_positions(sum_of(start, t, directions), patch.jacobian, patch.state);
    patch.state.measure(patch.pool);
    return inner_defects(patch.state);
  };
  constexpr double h = 1e-6;
  const VectorXd slope = (defects_at(h) - defects_at(-h)) / (2.0 * h);
  const VectorXd expected = -patch.jacobian.times(directions);
  EXPECT_LT((slope - expected).norm(), 1e-8 * expected.norm());
}

TEST(AngleJacobian, HasNoColumnsForWhatMayNotMove) {
  Constraints constraints;
  const TriMesh mesh = make_shape("panel", 150);
  const Patch surface(mesh);
  constraints.fixed = {surface.inner_vertices()[10], surface.inner_vertices()[11]};
  PatchWithJacobian patch(constraints);
  std::size_t held = 0;
  for (Index v = 0; v < patch.state.inner_count(); ++v) {
    if (!patch.state.is_fixed(v)) continue;
    ++held;
    EXPECT_FALSE(patch.jacobian.is_movable(v));
    EXPECT_TRUE(patch.jacobian.column(v).empty());
    EXPECT_EQ(patch.dense.middleCols(3 * v, 3).norm(), 0.0);
    EXPECT_GT(patch.dense.row(v).norm(), 0.0);
  }
  EXPECT_EQ(held, 2U);
}

}  // namespace
}  // namespace planish
