#include "energy/angle_jacobian.h"

#include <utility>

#include <planish/mesh/shapes.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "evolve/systems/dual_system.h"
#include "evolve/systems/positions.h"

namespace planish {
namespace {

struct Panel {
  Panel() : state(Patch(make_shape("panel", 300)), pool), whole(angle_jacobian_of(state)) {
    whole.update(state.positions(), pool);
    for (Index v = 40; v < 120; v += (v % 3) + 1)
      rows.push_back(v);
    movable.assign(state.inner_count(), 0);
    for (Index v = 50; v < 110; v += 2)
      movable[v] = 1;
  }
  Eigen::MatrixXd dense(const AngleJacobian& jacobian) const {
    const auto columns = static_cast<Eigen::Index>(3 * state.inner_count());
    Eigen::MatrixXd dense =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(jacobian.row_count()), columns);
    for (Index v = 0; v < state.inner_count(); ++v) {
      for (const AngleJacobian::Entry& entry : jacobian.column(v)) {
        const Vec3 g = jacobian.gradient(entry.entry);
        dense.block(entry.row, 3 * v, 1, 3) = Eigen::RowVector3d(g.x, g.y, g.z);
      }
    }
    return dense;
  }

  ThreadPool pool{1};
  PatchState state;
  AngleJacobian whole;
  std::vector<Index> rows;
  std::vector<unsigned char> movable;
};

TEST(AngleJacobian, HasTheGradientsOfDifferenceQuotients) {
  const Panel panel;
  std::vector<Vec3> x = all_positions(panel.state);
  const auto at = [&](Index v) { return x[v]; };
  constexpr double h = 1e-6;
  for (Index v = 20; v < 40; ++v) {
    for (const AngleJacobian::Entry& entry : panel.whole.column(v)) {
      const Vec3 gradient = panel.whole.gradient(entry.entry), from = x[v];
      for (const auto& [axis, slope] :
           {std::pair{Vec3{1, 0, 0}, gradient.x}, std::pair{Vec3{0, 1, 0}, gradient.y},
            std::pair{Vec3{0, 0, 1}, gradient.z}}) {
        x[v] = from + h * axis;
        const double above = panel.whole.angle_sum(entry.row, at);
        x[v] = from - h * axis;
        const double below = panel.whole.angle_sum(entry.row, at);
        EXPECT_NEAR(slope, (above - below) / (2.0 * h), 1e-6 * (1.0 + norm(gradient)));
      }
      x[v] = from;
    }
  }
}

TEST(AngleJacobianPart, HasTheEntriesOfTheWhole) {
  Panel panel;
  AngleJacobian part = panel.whole.part(panel.rows, panel.movable);
  part.update(panel.state.positions(), panel.pool);
  ASSERT_EQ(part.row_count(), panel.rows.size());
  const Eigen::MatrixXd whole = panel.dense(panel.whole), dense = panel.dense(part);
  for (Index row = 0; row < part.row_count(); ++row) {
    EXPECT_EQ(part.vertex_of(row), panel.rows[row]);
    for (Index v = 0; v < panel.state.inner_count(); ++v) {
      const Eigen::RowVector3d expected = panel.movable[v] != 0
                                              ? whole.block<1, 3>(panel.rows[row], 3 * v).eval()
                                              : Eigen::RowVector3d::Zero().eval();
      EXPECT_EQ((dense.block<1, 3>(row, 3 * v)), expected) << row << " " << v;
    }
  }
}

TEST(AngleJacobianPart, IsSolvedWithADampingForEachRow) {
  Panel panel;
  AngleJacobian part = panel.whole.part(panel.rows, panel.movable);
  part.update(panel.state.positions(), panel.pool);
  const auto n = static_cast<Eigen::Index>(panel.rows.size());
  Eigen::VectorXd scales(3 * static_cast<Eigen::Index>(panel.state.inner_count()));
  std::vector<double> inverse_weights, damping;
  for (std::size_t v = 0; v < panel.state.inner_count(); ++v) {
    inverse_weights.push_back(1.0 + 0.1 * static_cast<double>(v % 7));
    scales.segment<3>(static_cast<Eigen::Index>(3 * v)).setConstant(inverse_weights.back());
  }
  for (Eigen::Index row = 0; row < n; ++row)
    damping.push_back(0.01 * static_cast<double>(row + 1));
  DualSystem dual(part, panel.state);
  ASSERT_TRUE(dual.factor_with(inverse_weights, damping, panel.pool));
  const Eigen::VectorXd right = Eigen::VectorXd::LinSpaced(n, -1.0, 2.0);
  const Eigen::MatrixXd a = panel.dense(part);
  Eigen::MatrixXd matrix = a * scales.asDiagonal() * a.transpose();
  for (Eigen::Index row = 0; row < n; ++row)
    matrix(row, row) += damping[static_cast<std::size_t>(row)];
  const Eigen::VectorXd expected = matrix.ldlt().solve(right);
  EXPECT_LE((dual.solve(right, panel.pool) - expected).norm(), 1e-10 * expected.norm());
}

}  // namespace
}  // namespace planish
